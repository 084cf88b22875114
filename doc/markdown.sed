# SPDX-License-Identifier: GPL-3.0-or-later
# From Markdown that any viewer shows to what all versions of Doxygen take.
# a table of contents below the title
1a [TOC]
# marks of what CGAL's own manual would not say; Doxygen drops the spaces around comments
s/<!-- only here -->//g
s/<!-- end -->//g
# equations
/^```math$/,/^```$/ { s/^```math$/\\f[/; s/^```$/\\f]/ }
s/\$`\([^`]*\)`\$/\\f$\1\\f$/g
# examples, whose code is shown, and citations
s/^\[\([a-z_]*\.cpp\)\](\.\.\/examples\/[a-z_]*\.cpp)$/\\cgalExample{\1}/
s/\[\[\([a-z-]*\)\]\](bibliography\.bib)/\\cgalCite{\1}/g
# links to pages, which are called like their files but for two
s/](manual\.md/](index.html/g
s/](CHANGES\.md/](history.html/g
s/](\([a-z_]*\)\.md/](\1.html/g
# files outside of this folder are not a part of the manual
s/\[\([^]]*\)\](\.\.\/[^)]*)/\1/g
