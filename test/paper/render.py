# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pictures of paper_experiments with VTK, off screen: render.py DATA_FOLDER PICTURE_FOLDER [NAME...]

NAME.panels in the data folder lists the panels of a picture. How they are seen stands here: the
same camera for all panels of a picture.
"""
import os
import sys

import vtk

WIDTH = 1200  # pixels; readers see it at about 900
CAPTION, BAR = 58, 64  # pixels below each row and below all
CLAY = (0.80, 0.77, 0.70)

# columns, height of a panel by its width, direction to the camera, up, zoom, and where the middle of the view is,
# in radii of the first panel to the right and up of its middle. A picture may show some panels of another.
HEAD = dict(columns=3, aspect=1.05, to_camera=(0.45, -1, 0.1), up=(0, 0, 1), zoom=1.2, shift=(0, 0.06))
FACADE = dict(columns=3, aspect=0.9, to_camera=(0.25, -1, 0.12), up=(0, 0, 1), zoom=1.17)
BUNNY = dict(columns=3, aspect=1.0, to_camera=(0.1, 0.1, 1), up=(0, 1, 0), zoom=1.12)
VIEWS = {
    "fig2": HEAD,
    "fig4": dict(columns=3, aspect=0.75, to_camera=(0.5, 0.5, 1), up=(0, 1, 0), zoom=1.2, shift=(0.02, -0.06)),
    "fig6": HEAD,
    "fig7": dict(columns=5, aspect=1.0, to_camera=(1, 0.75, 0.6), up=(0, 0, 1), zoom=0.92),
    "fig8": dict(columns=3, aspect=0.8, to_camera=(0.6, 0.7, 1), up=(0, 1, 0), zoom=1.07),
    "fig9_building": FACADE,
    "fig9_building_surface": FACADE,
    "fig9_bunny": BUNNY,
    "fig9_bunny_surface": BUNNY,
    "scan_before_after": dict(FACADE, columns=2, panels=("fig9_building", (0, 4)), captions=("a scan of CGAL's data", "smoothed with the defaults")),
    "reconstruction": dict(FACADE, columns=2, panels=("fig9_building_surface", (0, 4)), captions=("surface of the raw points", "surface of the smoothed points")),
}
DIVERGING = [(0.02, 0.19, 0.55), (0.35, 0.60, 0.85), (0.93, 0.92, 0.89), (0.90, 0.50, 0.35), (0.55, 0.05, 0.10)]
SEQUENTIAL = [(0.16, 0.25, 0.52), (0.15, 0.55, 0.60), (0.55, 0.78, 0.40), (0.98, 0.88, 0.25), (0.85, 0.20, 0.10)]


def read_list(file):
    panels, value_range = [], None
    with open(file, encoding="utf-8") as lines:
        for line in lines:
            kind, *rest = line.rstrip("\n").split("\t")
            if kind == "range":
                value_range = (float(rest[0]), float(rest[1]), rest[2])
            else:
                panels.append(rest)
    return panels, value_range


def color_map(low, high):
    colors = DIVERGING if low < 0 else SEQUENTIAL
    function = vtk.vtkColorTransferFunction()
    for i, color in enumerate(colors):
        function.AddRGBPoint(low + (high - low) * i / (len(colors) - 1), *color)
    return function


def read_data(file):
    reader = vtk.vtkPolyDataReader()
    reader.SetFileName(file)
    reader.ReadAllScalarsOn()
    reader.ReadAllNormalsOn()
    reader.ReadAllFieldsOn()
    reader.Update()
    return reader.GetOutput()


def disc_glyphs(data):
    """An oriented disc for each point, which hides what is behind it"""
    radius = data.GetFieldData().GetArray("disc_radius")
    disc = vtk.vtkRegularPolygonSource()
    disc.SetNumberOfSides(10)
    disc.SetRadius(radius.GetValue(0))
    disc.SetNormal(1, 0, 0)  # what glyphs turn to the normals
    disc.GeneratePolylineOff()
    glyphs = vtk.vtkGlyph3D()
    glyphs.SetInputData(data)
    glyphs.SetSourceConnection(disc.GetOutputPort())
    glyphs.SetVectorModeToUseNormal()
    glyphs.OrientOn()
    glyphs.SetScaleModeToDataScalingOff()
    glyphs.SetColorModeToColorByScalar()
    glyphs.Update()
    result = glyphs.GetOutput()
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(result)
    normals.ComputePointNormalsOff()
    normals.ComputeCellNormalsOn()
    normals.ConsistencyOff()
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


def panel_actor(data, colors):
    is_mesh = data.GetNumberOfPolys() > 0
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data if is_mesh else disc_glyphs(data))
    has_values = data.GetPointData().GetScalars() is not None
    mapper.SetScalarVisibility(has_values)
    if has_values:
        mapper.SetLookupTable(colors)
        mapper.InterpolateScalarsBeforeMappingOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*CLAY)
    look.SetAmbient(0.18)
    look.SetDiffuse(0.82)
    look.SetSpecular(0.12)
    look.SetSpecularPower(18)
    if is_mesh:
        look.SetInterpolationToFlat()
    return actor


def caption_actor(text, size, bold=False):
    actor = vtk.vtkTextActor()
    actor.SetInput(text)
    style = actor.GetTextProperty()
    style.SetFontSize(size)
    style.SetColor(0.1, 0.1, 0.1)
    style.SetJustificationToCentered()
    style.SetFontFamilyToArial()
    style.SetBold(bold)
    return actor


def add_captions(renderer, caption, width):
    for i, text in enumerate(caption.split("|")):
        size = 19 if width >= 350 else 15
        actor = caption_actor(text, size if i == 0 else size - 2, bold=i == 0)
        actor.SetPosition(width / 2, CAPTION - 26 - 24 * i)
        renderer.AddViewProp(actor)


def add_bar(renderer, colors, value_range):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(colors)
    bar.SetOrientationToHorizontal()
    bar.SetPosition(0.25, 0.0)
    bar.SetPosition2(0.5, 0.62)
    bar.SetTextPositionToPrecedeScalarBar()
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.3g")
    bar.UnconstrainedFontSizeOn()
    bar.GetLabelTextProperty().SetFontSize(16)
    bar.GetLabelTextProperty().SetColor(0.1, 0.1, 0.1)
    for style in (bar.GetLabelTextProperty(),):
        style.ItalicOff()
        style.ShadowOff()
        style.BoldOff()
    renderer.AddViewProp(bar)
    title = caption_actor(value_range[2], 17)
    title.SetPosition(WIDTH / 2, BAR - 20)
    renderer.AddViewProp(title)


def set_camera(renderer, bounds, view, aspect):
    center = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
    radius = sum((bounds[2 * i + 1] - bounds[2 * i]) ** 2 for i in range(3)) ** 0.5 / 2
    camera = renderer.GetActiveCamera()
    direction = view["to_camera"]
    length = sum(x * x for x in direction) ** 0.5
    right = [
        view["up"][1] * direction[2] - view["up"][2] * direction[1],
        view["up"][2] * direction[0] - view["up"][0] * direction[2],
        view["up"][0] * direction[1] - view["up"][1] * direction[0],
    ]
    right_length = sum(x * x for x in right) ** 0.5
    shift = view.get("shift", (0, 0))
    focus = [c + radius * (shift[0] * r / right_length + shift[1] * u) for c, r, u in zip(center, right, view["up"])]
    camera.SetFocalPoint(*focus)
    camera.SetPosition(*[f + 4 * radius * d / length for f, d in zip(focus, direction)])
    camera.SetViewUp(*view["up"])
    camera.ParallelProjectionOn()
    camera.SetParallelScale(radius * 0.8 / view["zoom"] * max(1, aspect))
    renderer.ResetCameraClippingRange()


def add_lights(renderer):
    kit = vtk.vtkLightKit()
    kit.SetKeyLightIntensity(0.9)
    kit.SetKeyLightWarmth(0.55)
    kit.SetKeyToFillRatio(2.6)
    kit.SetKeyToHeadRatio(4.5)
    kit.SetKeyLightAngle(45, -35)
    kit.AddLightsToRenderer(renderer)


def draw(name, data_folder, picture_folder):
    view = VIEWS[name]
    source, chosen = view.get("panels", (name, None))
    panels, value_range = read_list(os.path.join(data_folder, source + ".panels"))
    if chosen:
        panels = [(panels[i][0], caption) for i, caption in zip(chosen, view["captions"])]
    columns = view["columns"]
    rows = -(-len(panels) // columns)
    panel_width = WIDTH // columns
    panel_height = int(panel_width * view["aspect"])
    bar = BAR if value_range else 0
    height = rows * (panel_height + CAPTION) + bar

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(WIDTH, height)
    background = vtk.vtkRenderer()
    background.SetBackground(1, 1, 1)
    window.AddRenderer(background)
    colors = color_map(*value_range[:2]) if value_range else None

    bounds = None
    for i, (file, caption) in enumerate(panels):
        data = read_data(os.path.join(data_folder, file))
        bounds = bounds or data.GetBounds()
        left, top = (i % columns) * panel_width, height - (i // columns) * (panel_height + CAPTION)
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(left / WIDTH, (top - panel_height) / height, (left + panel_width) / WIDTH, top / height)
        renderer.SetBackground(1, 1, 1)
        renderer.AddActor(panel_actor(data, colors))
        add_lights(renderer)
        set_camera(renderer, bounds, view, view["aspect"])
        window.AddRenderer(renderer)
        strip = vtk.vtkRenderer()
        strip.SetViewport(left / WIDTH, (top - panel_height - CAPTION) / height, (left + panel_width) / WIDTH, (top - panel_height) / height)
        strip.SetBackground(1, 1, 1)
        add_captions(strip, caption, panel_width)
        window.AddRenderer(strip)
    if value_range:
        strip = vtk.vtkRenderer()
        strip.SetViewport(0, 0, 1, bar / height)
        strip.SetBackground(1, 1, 1)
        add_bar(strip, colors, value_range)
        window.AddRenderer(strip)
    window.Render()

    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(os.path.join(picture_folder, name + ".png"))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def main():
    data_folder, picture_folder, *names = sys.argv[1:]
    for name in names or VIEWS:
        source = VIEWS[name].get("panels", (name,))[0]
        if os.path.exists(os.path.join(data_folder, source + ".panels")):
            draw(name, data_folder, picture_folder)


if __name__ == "__main__":
    main()
