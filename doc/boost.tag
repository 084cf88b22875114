<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Boost's concepts that this manual refers to, as pages of its documentation of property maps -->
<tagfile>
  <compound kind="class">
    <name>ReadablePropertyMap</name>
    <filename>ReadablePropertyMap.html</filename>
  </compound>
  <compound kind="class">
    <name>WritablePropertyMap</name>
    <filename>WritablePropertyMap.html</filename>
  </compound>
  <compound kind="class">
    <name>ReadWritePropertyMap</name>
    <filename>ReadWritePropertyMap.html</filename>
  </compound>
  <compound kind="class">
    <name>LvaluePropertyMap</name>
    <filename>LvaluePropertyMap.html</filename>
  </compound>
</tagfile>
