#include "campaign/messages.hpp"

#include <concepts>
#include <memory>
#include <sstream>
#include <type_traits>

#include "solver/quantities.hpp"
#include "solver/soils/law.hpp"

namespace cpt::campaign {
namespace {

template <class T, class Struct>
concept MaybeConst = std::same_as<std::remove_const_t<T>, Struct>;

// One list of fields for both directions. Structs without a list go as their bytes.
template <class Archive>
void exchange(Archive& archive, MaybeConst<Hello> auto& hello) {
  archive(hello.node, hello.slots);
}

template <class Archive>
void exchange(Archive& archive, MaybeConst<ProgressReport> auto& report) {
  archive(report.realization, report.progress);
}

// Each item of a vector.
template <class Archive, class Items, class Each>
void exchange_all(Archive& archive, Items& items, Each each) {
  constexpr std::uint64_t most = 1'000'000;
  auto count = static_cast<std::uint64_t>(items.size());
  archive(count);
  if constexpr (!std::is_const_v<Items>) {
    if (count > most) throw MalformedMessage("a list that is too long");
    items.resize(count);
  }
  for (auto& item : items) each(item);
}

template <class Archive>
void exchange_words(Archive& archive, auto& words) {
  exchange_all(archive, words, [&](auto& word) { archive(word); });
}

template <class Archive>
void exchange(Archive& archive, MaybeConst<solver::ExternalProgram> auto& program) {
  exchange_words(archive, program.command);
  archive(program.folder, program.version, program.template_name, program.template_text, program.results,
          program.limits);
  exchange_all(archive, program.inputs, [&](auto& input) {
    archive(input.name, input.unit, input.meaning, input.usual, input.min, input.max, input.integer);
  });
  exchange_all(archive, program.outputs, [&](auto& output) {
    archive(output.name, output.unit, output.meaning, output.over, output.over_unit);
  });
}

template <class Archive>
void exchange(Archive& archive, MaybeConst<OutcomeReport> auto& report) {
  auto& outcome = report.outcome;
  archive(report.realization, outcome.status, outcome.reason, outcome.profile.depth, outcome.audit,
          outcome.steps, outcome.material_points, outcome.wall_seconds, report.interrupted);
  for (const solver::Channel& channel : solver::channels()) archive(outcome.profile.*channel.values);
  exchange_all(archive, outcome.profile.declared,
               [&](auto& result) { archive(result.name, result.x, result.y); });
}

template <class Archive>
void exchange(Archive& archive, MaybeConst<Remark> auto& remark) {
  archive(remark.realization, remark.text);
}

template <class Archive>
void exchange(Archive&, MaybeConst<Stop> auto&) {}
template <class Archive>
void exchange(Archive&, MaybeConst<Leaving> auto&) {}
template <class Archive>
void exchange(Archive&, MaybeConst<Dismissed> auto&) {}

// A setup travels as its soils with their laws, the values of all quantities, its layers and its point zones,
// so that a new quantity needs no line here; its canonical text travels too and shows that nothing was left
// out. An external program travels whole.
void exchange(ByteWriter& archive, const Order& order) {
  std::vector<double> values;
  std::string soils;  // "sand norsand clay tresca"
  for (const solver::Soil& soil : order.setup.soils)
    soils += soil.name + ' ' + std::string(solver::law_of(soil).name()) + ' ';
  for (const solver::Quantity* quantity : solver::quantities_of(order.setup))
    values.push_back(quantity->get(order.setup));
  archive(order.realization, order.threads, order.wall_limit_seconds, order.hang_limit_seconds, soils, values,
          order.setup.layers, order.setup.numerics.zones, solver::canonical_text(order.setup),
          order.checkpoint, order.checkpoint_seconds, order.work, order.setup.program != nullptr);
  if (order.setup.program) exchange(archive, *order.setup.program);
}

void exchange(ByteReader& archive, Order& order) {
  std::vector<double> values;
  std::vector<solver::Layer> layers;
  std::vector<solver::PointZone> zones;
  std::string soils, text;
  bool external = false;
  archive(order.realization, order.threads, order.wall_limit_seconds, order.hang_limit_seconds, soils, values,
          layers, zones, text, order.checkpoint, order.checkpoint_seconds, order.work, external);
  if (external) {
    solver::ExternalProgram program;
    exchange(archive, program);
    order.setup.program_inputs.resize(program.inputs.size());
    order.setup.program = std::make_shared<const solver::ExternalProgram>(std::move(program));
  }
  order.setup.soils.clear();
  std::istringstream words(soils);
  for (std::string name, law; words >> name >> law;) {
    if (solver::find_law(law) == nullptr) throw MalformedMessage("order with an unknown law");
    order.setup.soils.push_back({name, solver::find_law(law)->defaults()});
  }
  const auto quantities = solver::quantities_of(order.setup);
  if (values.size() != quantities.size()) throw MalformedMessage("order of another program version");
  for (std::size_t i = 0; i < values.size(); ++i) quantities[i]->set(order.setup, values[i]);
  for (const solver::Layer& layer : layers)
    if (layer.soil >= order.setup.soils.size()) throw MalformedMessage("order with a layer of no soil");
  order.setup.layers = std::move(layers);
  order.setup.numerics.zones = std::move(zones);
  if (solver::canonical_text(order.setup) != text)
    throw MalformedMessage("order's setup did not survive packing");
}

void check(const Message& message) {
  const auto* report = std::get_if<OutcomeReport>(&message);
  if (report == nullptr) return;
  const auto status = static_cast<int>(report->outcome.status);
  const auto& profile = report->outcome.profile;
  if (status < 0 || status > static_cast<int>(solver::Status::rank_lost))
    throw MalformedMessage("outcome with an unknown status");
  if (!solver::is_even(profile)) throw MalformedMessage("outcome with a ragged depth profile");
}

template <std::size_t I = 0>
Message decode_alternative(std::uint32_t kind, ByteReader& reader) {
  if constexpr (I < std::variant_size_v<Message>) {
    if (kind != I) return decode_alternative<I + 1>(kind, reader);
    std::variant_alternative_t<I, Message> content;
    exchange(reader, content);
    return content;
  } else {
    throw MalformedMessage("message of an unknown kind");
  }
}

struct FrameHeader {
  std::uint32_t magic;
  std::uint32_t size;
};
constexpr std::uint32_t frame_magic = 0x43505431;  // "CPT1"
constexpr std::uint32_t largest_message =
    64U << 20U;  // far above any depth profile; bounds what garbage can claim

}  // namespace

Bytes encode(const Message& message) {
  ByteWriter writer;
  writer(static_cast<std::uint32_t>(message.index()));
  std::visit([&](const auto& content) { exchange(writer, content); }, message);
  return writer.take();
}

Message decode(std::span<const std::byte> bytes) {
  ByteReader reader(bytes);
  std::uint32_t kind = 0;
  reader(kind);
  Message message = decode_alternative(kind, reader);
  reader.expect_end();
  check(message);
  return message;
}

Bytes frame(const Message& message) {
  const Bytes content = encode(message);
  const FrameHeader header{frame_magic, static_cast<std::uint32_t>(content.size())};
  Bytes bytes(sizeof header + content.size());
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, content.data(), content.size());
  return bytes;
}

void FrameReader::feed(std::span<const std::byte> bytes) {
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

std::optional<Message> FrameReader::next() {
  FrameHeader header{};
  if (buffer_.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, buffer_.data(), sizeof header);
  if (header.magic != frame_magic || header.size > largest_message)
    throw MalformedMessage("bytes that are no message");
  const std::size_t end = sizeof header + header.size;
  if (buffer_.size() < end) return std::nullopt;
  Message message = decode(std::span(buffer_).subspan(sizeof header, header.size));
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(end));
  return message;
}

}  // namespace cpt::campaign
