#include "results/files/file_system.hpp"

#include <sys/vfs.h>

#include <algorithm>
#include <iterator>

namespace cpt::results {
namespace {

constexpr std::uint64_t network_magics[] = {
    0x6969,      // NFS
    0x517b,      // SMB
    0xff534d42,  // CIFS
    0xfe534d42,  // SMB 2 and 3
    0x0bd00bd0,  // Lustre
    0x47504653,  // GPFS (Spectrum Scale)
    0x19830326,  // BeeGFS
    0x00c36400,  // Ceph
    0x5346414f,  // AFS
    0x6b414653,  // AFS of the kernel
    0x73757245,  // Coda
    0x01161970,  // GFS2
    0x7461636f,  // OCFS2
    0x20030528,  // OrangeFS
    0xaad7aaea,  // PanFS
    0x01021997,  // 9P
    0x65735546,  // FUSE: sshfs, GlusterFS and others
    0x786f4256,  // folder shared with VirtualBox
    0xbacbacbc,  // folder shared with VMware
};

}  // namespace

FileSystem file_system_of_magic(std::uint64_t magic) {
  const bool network =
      std::find(std::begin(network_magics), std::end(network_magics), magic) != std::end(network_magics);
  return network ? FileSystem::network : FileSystem::local;
}

FileSystem file_system_of(const std::filesystem::path& file) {
  struct statfs about {};
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (::statfs(folder.c_str(), &about) != 0) return FileSystem::network;
  return file_system_of_magic(static_cast<std::uint32_t>(about.f_type));
}

}  // namespace cpt::results
