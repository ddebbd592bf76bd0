#include "campaign/mpi_transport.hpp"

#include <mpi.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <list>
#include <set>

namespace cpt::campaign {
namespace {

constexpr int message_tag = 1;
constexpr const char* launcher_ranks[] = {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"};

// A send in flight; MPI needs its bytes until it is done.
struct Sending {
  Bytes bytes;
  MPI_Request request = MPI_REQUEST_NULL;
};

// A message that is being received.
struct Receiving {
  int from;
  Bytes bytes;
  MPI_Request request = MPI_REQUEST_NULL;
};

bool done(MPI_Request& request) {
  int flag = 0;
  MPI_Test(&request, &flag, MPI_STATUS_IGNORE);
  return flag != 0;
}

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
  std::list<Receiving> receiving;  // in the order of their arrival

  // Begins to receive what has been announced. To wait for the rest of a long message would be to wait for
  // its sender's next poll.
  void receive_announced() {
    for (;;) {
      int announced = 0;
      MPI_Message message = MPI_MESSAGE_NULL;
      MPI_Status status;
      MPI_Improbe(MPI_ANY_SOURCE, message_tag, MPI_COMM_WORLD, &announced, &message, &status);
      if (announced == 0) return;
      int length = 0;
      MPI_Get_count(&status, MPI_BYTE, &length);
      Receiving& item = receiving.emplace_back();
      item.from = status.MPI_SOURCE;
      item.bytes.resize(static_cast<std::size_t>(length));
      MPI_Imrecv(item.bytes.data(), length, MPI_BYTE, &message, &item.request);
    }
  }

  // The first that is whole; none of a rank overtakes an earlier one.
  std::list<Receiving>::iterator first_whole() {
    std::set<int> waiting;
    for (auto item = receiving.begin(); item != receiving.end(); ++item)
      if (!waiting.contains(item->from)) {
        if (done(item->request)) return item;
        waiting.insert(item->from);
      }
    return receiving.end();
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
  auto whole = state_->first_whole();
  if (whole == state_->receiving.end()) {
    state_->sending.remove_if([](Sending& item) { return done(item.request); });
    state_->receive_announced();
    whole = state_->first_whole();
  }
  if (whole == state_->receiving.end()) return std::nullopt;
  const Receiving message = std::move(*whole);
  state_->receiving.erase(whole);
  return Received{message.from, decode(message.bytes)};
}

double MpiTransport::longest_nap() const {
  return state_->sending.empty() && state_->receiving.empty() ? 0.02 : 0.001;
}

void MpiTransport::abandon(int exit_code) {
  std::fflush(nullptr);  // nothing does it after this
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::_Exit(exit_code);
}

}  // namespace cpt::campaign
