# SPDX-License-Identifier: GPL-3.0-or-later
# From Markdown that any viewer shows to what Doxygen takes: a table of contents below the title, and
# links to the main page, which Doxygen does not find by the name of its file.
1a [TOC]
s/](manual\.md/](index.html/g
