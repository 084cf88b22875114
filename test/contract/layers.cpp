// SPDX-License-Identifier: GPL-3.0-or-later
// Layers: what tells which of them are two sheets, and which are one surface scanned twice. One program, since
// all of its tests would compile the same.
#define BOOST_TEST_MODULE layers
#include <boost/test/unit_test.hpp>

#include "layers_found_sides.h"
#include "layers_given_normals.h"
#include "layers_scan_numbers.h"
