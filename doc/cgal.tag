<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Those of CGAL's entities that this manual refers to, as pages of https://doc.cgal.org/latest -->
<tagfile>
  <compound kind="class">
    <name>CGAL::Point_set_3</name>
    <filename>Point_set_3/classCGAL_1_1Point__set__3.html</filename>
  </compound>
  <compound kind="class">
    <name>Kernel</name>
    <filename>Kernel_23/classKernel.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Kernel_traits</name>
    <filename>Kernel_23/structCGAL_1_1Kernel__traits.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Simple_cartesian</name>
    <filename>Kernel_23/structCGAL_1_1Simple__cartesian.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Exact_predicates_inexact_constructions_kernel</name>
    <filename>Kernel_23/classCGAL_1_1Exact__predicates__inexact__constructions__kernel.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Point_3</name>
    <filename>Kernel_23/classCGAL_1_1Point__3.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Vector_3</name>
    <filename>Kernel_23/classCGAL_1_1Vector__3.html</filename>
  </compound>
  <compound kind="class">
    <name>Range</name>
    <filename>Circulator/classRange.html</filename>
  </compound>
  <compound kind="class">
    <name>ConstRange</name>
    <filename>Circulator/classConstRange.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Sequential_tag</name>
    <filename>STL_Extension/structCGAL_1_1Sequential__tag.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Parallel_tag</name>
    <filename>STL_Extension/structCGAL_1_1Parallel__tag.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Parallel_if_available_tag</name>
    <filename>STL_Extension/structCGAL_1_1Parallel__if__available__tag.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Identity_property_map</name>
    <filename>Property_map/structCGAL_1_1Identity__property__map.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::First_of_pair_property_map</name>
    <filename>Property_map/structCGAL_1_1First__of__pair__property__map.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Second_of_pair_property_map</name>
    <filename>Property_map/structCGAL_1_1Second__of__pair__property__map.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Nth_of_tuple_property_map</name>
    <filename>Property_map/structCGAL_1_1Nth__of__tuple__property__map.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Kd_tree</name>
    <filename>Spatial_searching/classCGAL_1_1Kd__tree.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Orthogonal_k_neighbor_search</name>
    <filename>Spatial_searching/classCGAL_1_1Orthogonal__k__neighbor__search.html</filename>
  </compound>
  <compound kind="namespace">
    <name>CGAL</name>
    <filename>Manual/namespaceCGAL.html</filename>
    <member kind="function">
      <type></type>
      <name>jet_smooth_point_set</name>
      <anchorfile>Point_set_processing_3/group__PkgPointSetProcessing3Algorithms.html</anchorfile>
      <anchor>func-members</anchor>
      <arglist>(PointRange &amp;points, unsigned int k, const NamedParameters &amp;np=parameters::default_values())</arglist>
    </member>
    <member kind="function">
      <type></type>
      <name>bilateral_smooth_point_set</name>
      <anchorfile>Point_set_processing_3/group__PkgPointSetProcessing3Algorithms.html</anchorfile>
      <anchor>func-members</anchor>
      <arglist>(PointRange &amp;points, unsigned int k, const NamedParameters &amp;np=parameters::default_values())</arglist>
    </member>
    <member kind="function">
      <type></type>
      <name>pca_estimate_normals</name>
      <anchorfile>Point_set_processing_3/group__PkgPointSetProcessing3Algorithms.html</anchorfile>
      <anchor>func-members</anchor>
      <arglist>(PointRange &amp;points, unsigned int k, const NamedParameters &amp;np=parameters::default_values())</arglist>
    </member>
    <member kind="function">
      <type></type>
      <name>jet_estimate_normals</name>
      <anchorfile>Point_set_processing_3/group__PkgPointSetProcessing3Algorithms.html</anchorfile>
      <anchor>func-members</anchor>
      <arglist>(PointRange &amp;points, unsigned int k, const NamedParameters &amp;np=parameters::default_values())</arglist>
    </member>
    <member kind="function">
      <type></type>
      <name>mst_orient_normals</name>
      <anchorfile>Point_set_processing_3/group__PkgPointSetProcessing3Algorithms.html</anchorfile>
      <anchor>func-members</anchor>
      <arglist>(PointRange &amp;points, unsigned int k, const NamedParameters &amp;np=parameters::default_values())</arglist>
    </member>
    <member kind="function">
      <type></type>
      <name>remove_outliers</name>
      <anchorfile>Point_set_processing_3/group__PkgPointSetProcessing3Algorithms.html</anchorfile>
      <anchor>func-members</anchor>
      <arglist>(PointRange &amp;points, unsigned int k, const NamedParameters &amp;np=parameters::default_values())</arglist>
    </member>
    <member kind="function">
      <type></type>
      <name>compute_average_spacing</name>
      <anchorfile>Point_set_processing_3/group__PkgPointSetProcessing3Algorithms.html</anchorfile>
      <anchor>func-members</anchor>
      <arglist>(PointRange &amp;points, unsigned int k, const NamedParameters &amp;np=parameters::default_values())</arglist>
    </member>
  </compound>
</tagfile>
