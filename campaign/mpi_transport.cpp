#include "campaign/mpi_transport.hpp"

#include <mpi.h>
#include <unistd.h>

#include <cstdlib>
#include <list>

namespace cpt::campaign {
namespace {

constexpr int message_tag = 1;
constexpr const char* launcher_ranks[] = {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"};

// A send in flight; MPI needs its bytes until it is done.
struct Sending {
  Bytes bytes;
  MPI_Request request = MPI_REQUEST_NULL;
};

}  // namespace

bool started_by_mpi() {
  for (const char* name : launcher_ranks)
    if (std::getenv(name) != nullptr) return true;
  return false;
}

int rank_from_environment() {
  for (const char* name : launcher_ranks)
    if (const char* value = std::getenv(name)) return std::atoi(value);
  return 0;
}

struct MpiTransport::State {
  int rank = 0, size = 1, node = 0, ranks_on_node = 1, rank_on_node = 0;
  pid_t launcher = ::getppid();
  std::list<Sending> sending;

  void drop_sent() {
    sending.remove_if([](Sending& item) {
      int done = 0;
      MPI_Test(&item.request, &done, MPI_STATUS_IGNORE);
      return done != 0;
    });
  }
};

MpiTransport::MpiTransport() : state_(std::make_unique<State>()) {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SINGLE, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &state_->rank);
  MPI_Comm_size(MPI_COMM_WORLD, &state_->size);
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  MPI_Comm_size(node, &state_->ranks_on_node);
  MPI_Comm_rank(node, &state_->rank_on_node);
  state_->node = state_->rank;
  MPI_Bcast(&state_->node, 1, MPI_INT, 0, node);  // a node is named after its lowest rank
  MPI_Comm_free(&node);
}

MpiTransport::~MpiTransport() {
  for (Sending& item : state_->sending) MPI_Wait(&item.request, MPI_STATUS_IGNORE);
  MPI_Finalize();
}

int MpiTransport::rank() const { return state_->rank; }
int MpiTransport::size() const { return state_->size; }
int MpiTransport::node() const { return state_->node; }
int MpiTransport::ranks_on_node() const { return state_->ranks_on_node; }
int MpiTransport::rank_on_node() const { return state_->rank_on_node; }
bool MpiTransport::orphaned() const { return ::getppid() != state_->launcher; }

void MpiTransport::send(int to, const Message& message) {
  Sending& item = state_->sending.emplace_back();
  item.bytes = encode(message);
  MPI_Isend(item.bytes.data(), static_cast<int>(item.bytes.size()), MPI_BYTE, to, message_tag, MPI_COMM_WORLD,
            &item.request);
}

std::optional<Received> MpiTransport::poll() {
  state_->drop_sent();
  int arrived = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, message_tag, MPI_COMM_WORLD, &arrived, &status);
  if (arrived == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Bytes bytes(static_cast<std::size_t>(size));
  MPI_Recv(bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, message_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return Received{status.MPI_SOURCE, decode(bytes)};
}

void MpiTransport::abandon(int exit_code) {
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::_Exit(exit_code);
}

}  // namespace cpt::campaign
