// SPDX-License-Identifier: GPL-3.0-or-later
// Work of the engine on a thread of its own, while the calling thread answers Ctrl-C and hands progress to Python.
#pragma once

#include "core/cancel.h"

#include <pybind11/pybind11.h>

#include <functional>

namespace loopmend {

/// Arguments for the Python function that receives progress.
using Event = std::function<pybind11::tuple()>;
/// Takes an event from any thread; it is delivered later, by the thread that called run_interruptibly().
using PostEvent = std::function<void(Event)>;

/// What the first KeyboardInterrupt does.
enum class OnInterrupt {
  raise,         ///< it goes on when the work has ended
  keep_finished  ///< it cancels the work, which hands back what it has; only a second one goes on
};

/// Calls work(cancel, post) without the GIL, and looks for signals 20 times a second. A signal's exception, or one that
/// `on_event` raises, cancels the work; when that has ended, the exception goes on. Events are delivered in their order, all of
/// them, those made while an exception is under way excepted.
/// @param on_event  called with an event's tuple; None: no progress is reported.
/// @throws Error where the system allows no further thread; what the work threw, where no exception of Python came first.
void run_interruptibly(const std::function<void(const CancelToken& cancel, const PostEvent& post)>& work,
                       const pybind11::object& on_event, OnInterrupt on_interrupt = OnInterrupt::raise);

}  // namespace loopmend
