#include "body/engine/bound_calls.hpp"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "body/engine/own_math.hpp"
#include "core/portable_math.hpp"

namespace farrier::body {
namespace {

#if defined(__x86_64__)
constexpr auto kJumpSlot = R_X86_64_JUMP_SLOT;
constexpr auto kDataSlot = R_X86_64_GLOB_DAT;
#elif defined(__aarch64__)
constexpr auto kJumpSlot = R_AARCH64_JUMP_SLOT;
constexpr auto kDataSlot = R_AARCH64_GLOB_DAT;
#else
#error "add the processor's names of relocations"
#endif

/// The library's imports, found by its dynamic section.
struct Imports {
  ElfW(Addr) base = 0;
  const ElfW(Sym) * symbols = nullptr;
  const char* names = nullptr;
  std::span<const ElfW(Rela)> calls;  ///< through the procedure linkage table
  std::span<const ElfW(Rela)> data;
};

Imports imports_of(const link_map& library) {
  Imports imports;
  imports.base = library.l_addr;
  // The dynamic linker has turned these offsets to addresses on most processors.
  const auto address = [&library](ElfW(Addr) value) { return value < library.l_addr ? value + library.l_addr : value; };
  const ElfW(Rela)* calls = nullptr;
  const ElfW(Rela)* data = nullptr;
  std::size_t calls_bytes = 0;
  std::size_t data_bytes = 0;
  for (const ElfW(Dyn)* entry = library.l_ld; entry->d_tag != DT_NULL; ++entry) {
    switch (entry->d_tag) {
      case DT_SYMTAB:
        imports.symbols = reinterpret_cast<const ElfW(Sym)*>(address(entry->d_un.d_ptr));
        break;
      case DT_STRTAB:
        imports.names = reinterpret_cast<const char*>(address(entry->d_un.d_ptr));
        break;
      case DT_JMPREL:
        calls = reinterpret_cast<const ElfW(Rela)*>(address(entry->d_un.d_ptr));
        break;
      case DT_PLTRELSZ:
        calls_bytes = entry->d_un.d_val;
        break;
      case DT_RELA:
        data = reinterpret_cast<const ElfW(Rela)*>(address(entry->d_un.d_ptr));
        break;
      case DT_RELASZ:
        data_bytes = entry->d_un.d_val;
        break;
      default:
        break;
    }
  }
  imports.calls = {calls, calls != nullptr ? calls_bytes / sizeof(ElfW(Rela)) : 0};
  imports.data = {data, data != nullptr ? data_bytes / sizeof(ElfW(Rela)) : 0};
  return imports;
}

// The table is read-only in a library that was linked with "-z relro -z now".
bool write_slot(void** slot, void* function) {
  const auto page_bytes = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  auto* page = reinterpret_cast<void*>(reinterpret_cast<std::uintptr_t>(slot) & ~(page_bytes - 1));
  if (mprotect(page, page_bytes, PROT_READ | PROT_WRITE) != 0) {
    return false;
  }
  *slot = function;
  return true;
}

bool bind(const Imports& imports, std::span<const ElfW(Rela)> entries, const BoundCall& call) {
  bool found = false;
  for (const ElfW(Rela) & entry : entries) {
    const auto type = ELF64_R_TYPE(entry.r_info);
    if (type != kJumpSlot && type != kDataSlot) {
      continue;
    }
    const ElfW(Sym)& symbol = imports.symbols[ELF64_R_SYM(entry.r_info)];
    if (std::string_view(imports.names + symbol.st_name) == call.name) {
      found = write_slot(reinterpret_cast<void**>(imports.base + entry.r_offset), call.function) || found;
    }
  }
  return found;
}

}  // namespace

Result<Done> bind_calls(const void* inside, std::span<const BoundCall> calls) {
  Dl_info where{};
  link_map* library = nullptr;
  if (dladdr1(inside, &where, reinterpret_cast<void**>(&library), RTLD_DL_LINKMAP) == 0 || library == nullptr) {
    return Error{"the physics engine is no shared library: link libmujoco.so"};
  }
  const Imports imports = imports_of(*library);
  if (imports.symbols == nullptr || imports.names == nullptr) {
    return Error{std::string(where.dli_fname) + " has no table of imports: link Debian's libmujoco.so"};
  }
  for (const BoundCall& call : calls) {
    const bool by_call = bind(imports, imports.calls, call);
    const bool by_data = bind(imports, imports.data, call);
    if (call.required && !by_call && !by_data) {
      return Error{std::string(where.dli_fname) + " does not import " + call.name +
                   ": its steps would depend on the processor; link Debian's libmujoco.so 2.2.2"};
    }
  }
  return Done{};
}

Result<Done> bind_own_math(const void* inside) {
  const auto pointer = [](auto* function) { return reinterpret_cast<void*>(function); };
  const BoundCall calls[] = {
      {"sin", pointer(&portable::sin), false},           {"cos", pointer(&portable::cos), false},
      {"sincos", pointer(&own_math::sine_cosine), true}, {"atan2", pointer(&portable::atan2), true},
      {"pow", pointer(&own_math::power), true},          {"acos", pointer(&own_math::forbidden), false},
      {"asin", pointer(&own_math::forbidden), false},    {"exp", pointer(&own_math::forbidden), false},
      {"log", pointer(&own_math::forbidden), false},     {"tan", pointer(&own_math::forbidden), false}};
  return bind_calls(inside, calls);
}

}  // namespace farrier::body
