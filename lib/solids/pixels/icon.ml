let default_resolution = 128

let is_text = Svg_icon.is

let read ?(resolution = default_resolution) ~path text =
  if Pnm.is text then Pnm.read ~path text
  else if Png.is text then Png.read ~path text
  else if Svg_icon.is text then Svg_icon.read ~resolution ~path text
  else
    Picture_fault.unsupported ~path ~hint:"pictures are PNG, Netpbm (PBM, PGM, PPM) and SVG"
      "this is no picture that scc reads"
