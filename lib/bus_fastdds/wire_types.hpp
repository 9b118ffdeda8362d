#pragma once

// The types fastddsgen generates from idl/, paired with our signals and made safe for two threads.

#include "signals/fast_types.hpp"
#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <array>
#include <cstring>
#include <type_traits>
#include <vector>

#include "signals/cdr.hpp"

namespace farrier::bus_fastdds {

// Generated types have a vector for a sequence.
template <class Field>
const Field& to_wire(const Field& field) noexcept {
  return field;
}
template <class Enum>
requires std::is_enum_v<Enum> std::uint8_t to_wire(const Enum& field)
noexcept { return static_cast<std::uint8_t>(field); }
template <std::size_t kMost>
std::vector<std::uint8_t> to_wire(const signals::Octets<kMost>& octets) {
  return {octets.begin(), octets.end()};
}
template <class Field>
void from_wire(const Field& wire, Field& field) noexcept {
  field = wire;
}
template <class Enum>
requires std::is_enum_v<Enum>
void from_wire(std::uint8_t wire, Enum& field) noexcept { field = static_cast<Enum>(wire); }
template <std::size_t kMost>
void from_wire(const std::vector<std::uint8_t>& wire, signals::Octets<kMost>& octets) noexcept {
  octets.assign(wire);
}

/// The generated type of a signal, its generated codec, and the copies between the two.
template <class Signal>
struct Wire;

#define FARRIER_TO_WIRE(field) to.field(to_wire(from.field));
#define FARRIER_FROM_WIRE(field) from_wire(from.field(), to.field);
#define FARRIER_WIRE(Signal, file)                                                                                  \
  template <>                                                                                                       \
  struct Wire<signals::Signal> {                                                                                    \
    using Type = wire::Signal;                                                                                      \
    using Codec = wire::Signal##PubSubType;                                                                         \
    static void copy(Type& to, const signals::Signal& from) noexcept { FARRIER_FIELDS_##Signal(FARRIER_TO_WIRE) }   \
    static void copy(signals::Signal& to, const Type& from) noexcept { FARRIER_FIELDS_##Signal(FARRIER_FROM_WIRE) } \
  };
FARRIER_SIGNALS(FARRIER_WIRE)
#undef FARRIER_WIRE
#undef FARRIER_FROM_WIRE
#undef FARRIER_TO_WIRE

/// Fast DDS's type support of a signal: the generated codec, fed from and into our own struct, so that endpoints
/// write and take signals as they are.
template <class Signal>
class SignalType final : public Wire<Signal>::Codec {
  using Base = typename Wire<Signal>::Codec;
  using WireSignal = typename Wire<Signal>::Type;
  using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;
  using Handle = eprosima::fastrtps::rtps::InstanceHandle_t;

 public:
  SignalType() {
    // Cyclone 0.10 refuses an endpoint whose announcement carries either.
    this->auto_fill_type_object(false);
    this->auto_fill_type_information(false);
  }

  bool serialize(void* data, Payload* payload) override {
    WireSignal out;
    Wire<Signal>::copy(out, *static_cast<const Signal*>(data));
    return Base::serialize(&out, payload);
  }

  bool deserialize(Payload* payload, void* data) override {
    WireSignal in;
    try {
      if (!Base::deserialize(payload, &in)) {
        return false;
      }
    } catch (const eprosima::fastcdr::exception::Exception&) {  // an encapsulation that is not CDR
      return false;
    }
    Wire<Signal>::copy(*static_cast<Signal*>(data), in);
    return true;
  }

  // The generated getKey works in one buffer of the type, which the writing and the receiving thread share.
  bool getKey(void* data, Handle* handle,
              bool /*force_md5: of protected payloads, which no governance of ours has*/) override {
    WireSignal signal;
    Wire<Signal>::copy(signal, *static_cast<const Signal*>(data));
    std::array<char, kKeyBytes> key{};
    eprosima::fastcdr::FastBuffer buffer(key.data(), key.size());
    eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::BIG_ENDIANNESS);
    signal.serializeKey(cdr);
    std::memcpy(&handle->value[0], key.data(), kKeyBytes);
    return true;
  }

  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    const std::size_t unused = signals::most_octets<Signal>() - signals::octets_in(*static_cast<const Signal*>(data));
    return [size = this->m_typeSize - static_cast<std::uint32_t>(unused)] { return size; };
  }
  void* createData() override { return new Signal; }
  void deleteData(void* data) override { delete static_cast<Signal*>(data); }
  bool construct_sample(void* memory) const override {
    new (memory) Signal;
    return true;
  }
  bool is_plain() const override { return false; }

 private:
  static constexpr std::size_t kKeyBytes = 16;  // of a DDS key hash; keys of idl/ fit unhashed
};

}  // namespace farrier::bus_fastdds
