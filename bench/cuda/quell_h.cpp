// The functions of quell.h with presets for a device alone: for programs that compile these by themselves.
#define QUELL_CUDA_CODE
#define QUELL_ENTRIES quell_code_none
#define QUELL_CODES                                                                                                                        \
    { "none", quell_code_none, true }
#define QUELL_LIBRARY_VERSION ""
// g++ takes what is included for a header, whose types several files would have.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wsubobject-linkage"
#endif
#include <library/library.cpp>
