// SPDX-License-Identifier: GPL-3.0-or-later
// What a program of tests of the window hands to the main function that all of them share (test_main.cpp).
#pragma once

#include <QObject>

#include <memory>

namespace loopmend::testing {

/// Defined by each program: its test. Called once, when the application is there.
std::unique_ptr<QObject> make_test();

}  // namespace loopmend::testing
