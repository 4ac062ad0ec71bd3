"""A brush with a parameter of every type, of which tests derive theirs."""

import burin


class EveryParam(burin.Brush):
    height = burin.FloatParam(0.1, hard=(0, 1), soft=(0, 0.5), unit="radius", dynamic=True, help="How high.")
    count = burin.IntParam(3, hard=(1, 9))
    on = burin.BoolParam(True)
    form = burin.ChoiceParam(("round", "flat"), "flat")
    tint = burin.ColourParam((1, 0.5, 0.25, 1))
    file = burin.FileParam("")
    profile = burin.CurveParam([(0, 1), (1, 0)])
    word = burin.TextParam("Größe")
