// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_LICENSE_POINT_SET_FLOW_H
#define CGAL_LICENSE_POINT_SET_FLOW_H

// Each header of a CGAL package under the GPL includes the header of its license. CGAL generates that from
// its list of these packages, to tell users with a commercial license what it covers; this one stands in
// for it outside of CGAL's tree, where there is only the GPL.

#endif // CGAL_LICENSE_POINT_SET_FLOW_H
