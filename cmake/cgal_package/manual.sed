# SPDX-License-Identifier: GPL-3.0-or-later
# From what doc/markdown.sed makes of doc/manual.md to the user manual of a package inside CGAL.
# its title is in the template
/^# .*{#mainpage}$/ d
/^\[TOC\]$/ d
/^<!-- SPDX/ d
# CGAL has one space of names for the sections of all its packages
s/^## \(.*\) {#\([a-z_]*\)}$/\\section Point_set_flow_\2 \1/
s/^### \(.*\) {#\([a-z_]*\)}$/\\subsection Point_set_flow_\2 \1/
s/\[\([^]]*\)\](\(index\.html\)\{0,1\}#\([a-z_]*\))/\\ref Point_set_flow_\3 "\1"/g
s/\\cgalExample{/&Point_set_flow\//
