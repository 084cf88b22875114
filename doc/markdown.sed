# SPDX-License-Identifier: GPL-3.0-or-later
# From Markdown that any viewer shows to what all versions of Doxygen take: a table of contents below the
# title, and links to pages, which are called like their files but for two. Files outside of this folder
# are not a part of the manual.
1a [TOC]
s/](manual\.md/](index.html/g
s/](CHANGES\.md/](history.html/g
s/](\([a-z_]*\)\.md/](\1.html/g
s/\[\([^]]*\)\](\.\.\/[^)]*)/\1/g
