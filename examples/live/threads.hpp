#pragma once

#include <functional>

// What differs between the program that is one thread and the one whose work several share: one_thread.cpp or workers.cpp is linked.
namespace quell::live {

/// The threads that share work; the caller is one of them.
int thread_count();
/// Lets so many share work from now on, or as many as there are.
void set_thread_count(int count);
/// Calls turn(0) to turn(count - 1), each once and in any order, on all threads; returns when all are done.
void share(int count, std::function<void(int)> const& turn);

} // namespace quell::live
