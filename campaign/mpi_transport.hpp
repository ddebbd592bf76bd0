// Messages over MPI. The only file that knows MPI is mpi_transport.cpp.
#pragma once

#include <memory>

#include "campaign/transport.hpp"

namespace cpt::campaign {

/// True if this process was started by mpirun (or srun with PMIx).
[[nodiscard]] bool started_by_mpi();

/// Rank as the launcher's environment says it, before MPI is initialized; 0 without a launcher.
[[nodiscard]] int rank_from_environment();

/// Initializes MPI; its destructor finalizes it. All ranks make one; at most one in a process's life.
class MpiTransport final : public Transport {
 public:
  MpiTransport();
  ~MpiTransport() override;
  MpiTransport(const MpiTransport&) = delete;
  MpiTransport& operator=(const MpiTransport&) = delete;

  [[nodiscard]] int rank() const override;
  [[nodiscard]] int size() const override;
  [[nodiscard]] int node() const override;
  [[nodiscard]] int ranks_on_node() const override;
  [[nodiscard]] int rank_on_node() const override;
  void send(int to, const Message& message) override;
  [[nodiscard]] std::optional<Received> poll() override;
  [[nodiscard]] double longest_nap() const override;
  [[nodiscard]] bool orphaned() const override;

  /// Ends the process at once with this exit code, and with it the whole job: MPI_Finalize would wait for
  /// ranks that are gone. Everything of value must be on disk by then.
  [[noreturn]] void abandon(int exit_code);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cpt::campaign
