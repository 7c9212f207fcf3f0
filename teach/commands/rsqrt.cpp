// SPDX-License-Identifier: MIT
// LD_PRELOAD=librsqrt.so TEXEL_RSQRT=exact|high|low: llvmpipe's approximate 1/sqrt as other processors
// round it.
//
// Of RSQRTPS only a relative error below 1.5 * 2^-12 is specified, and processors differ within that (Intel,
// Software Developer's Manual, volume 2, RSQRTPS). llvmpipe asks LLVM for the instruction by its C interface.
// It gets a function that makes the result exact by two of Newton's steps, times 1 +- 1.5 * 2^-12.
#include <dlfcn.h>
#include <link.h>

#include <array>
#include <cstdlib>
#include <string_view>

namespace {

using Ref = void*;  // all of LLVM's handles are pointers

/// A function of the libLLVM that the driver opened.
template <class Function>
Function* llvm(const char* name) {
  static void* const library = [] {
    void* found = nullptr;
    const auto is_llvm = [](dl_phdr_info* object, std::size_t, void* result) {
      if (std::string_view(object->dlpi_name).find("libLLVM") == std::string_view::npos) return 0;
      *static_cast<void**>(result) = ::dlopen(object->dlpi_name, RTLD_LAZY | RTLD_NOLOAD);
      return 1;
    };
    ::dl_iterate_phdr(is_llvm, &found);
    return found;
  }();
  return reinterpret_cast<Function*>(::dlsym(library, name));
}

/// The number in each element of a vector like this one.
Ref constant(Ref like, double value) {
  const Ref type = llvm<Ref(Ref)>("LLVMTypeOf")(like);
  const Ref element = llvm<Ref(Ref)>("LLVMGetElementType")(type);
  std::array<Ref, 16> all{};
  all.fill(llvm<Ref(Ref, double)>("LLVMConstReal")(element, value));
  return llvm<Ref(Ref*, unsigned)>("LLVMConstVector")(all.data(),
                                                      llvm<unsigned(Ref)>("LLVMGetVectorSize")(type));
}

using Operation = Ref(Ref, Ref, Ref, const char*);
using Call = Ref(Ref, Ref, Ref, Ref*, unsigned, const char*);

Ref product(Ref builder, Ref a, Ref b) {
  return llvm<Operation>("LLVMBuildFMul")(builder, a, b, "");
}

bool is_rsqrt(Ref function) {
  std::size_t length = 0;
  const char* name = llvm<const char*(Ref, std::size_t*)>("LLVMGetValueName2")(function, &length);
  const std::string_view text = name == nullptr ? "" : name;
  return text == "llvm.x86.sse.rsqrt.ps" || text == "llvm.x86.avx.rsqrt.ps.256";
}

/// A function of the same module as the intrinsic: 1/sqrt times the factor that TEXEL_RSQRT asks for.
Ref displaced(Ref type, Ref intrinsic, std::string_view mode) {
  const Ref module = llvm<Ref(Ref)>("LLVMGetGlobalParent")(intrinsic);
  if (const Ref known = llvm<Ref(Ref, const char*)>("LLVMGetNamedFunction")(module, "texel_rsqrt"))
    return known;
  const Ref function = llvm<Ref(Ref, const char*, Ref)>("LLVMAddFunction")(module, "texel_rsqrt", type);
  const Ref context = llvm<Ref(Ref)>("LLVMGetModuleContext")(module);
  const Ref builder = llvm<Ref(Ref)>("LLVMCreateBuilderInContext")(context);
  llvm<void(Ref, Ref)>("LLVMPositionBuilderAtEnd")(
      builder, llvm<Ref(Ref, Ref, const char*)>("LLVMAppendBasicBlockInContext")(context, function, ""));
  Ref a = llvm<Ref(Ref, unsigned)>("LLVMGetParam")(function, 0);
  Ref result = llvm<Call>("LLVMBuildCall2")(builder, type, intrinsic, &a, 1, "");
  const Ref half = product(builder, a, constant(a, 0.5));
  for (int step = 0; step < 2; ++step) {  // r (1.5 - a/2 r^2)
    const Ref square = product(builder, result, result);
    const Ref rest =
        llvm<Operation>("LLVMBuildFSub")(builder, constant(a, 1.5), product(builder, half, square), "");
    result = product(builder, result, rest);
  }
  const double worst = 1.5 / 4096;
  const double factor = mode == "high" ? 1 + worst : mode == "low" ? 1 - worst : 1;
  llvm<Ref(Ref, Ref)>("LLVMBuildRet")(builder, product(builder, result, constant(a, factor)));
  llvm<void(Ref)>("LLVMDisposeBuilder")(builder);
  return function;
}

}  // namespace

extern "C" Ref LLVMBuildCall2(Ref builder, Ref type, Ref function, Ref* arguments, unsigned count,
                              const char* name) {
  const char* mode = std::getenv("TEXEL_RSQRT");
  if (mode != nullptr && is_rsqrt(function)) function = displaced(type, function, mode);
  return llvm<Call>("LLVMBuildCall2")(builder, type, function, arguments, count, name);
}
