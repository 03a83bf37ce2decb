let default_resolution = 128

let is_text = Svg_icon.is

let read_warned ?(resolution = default_resolution) ~path text =
  let alone picture = Result.map (fun raster -> (raster, [])) picture in
  let begins = List.exists (fun prefix -> String.starts_with ~prefix text) in
  if Pnm.is text then alone (Pnm.read ~path text)
  else if Png.is text then alone (Png.read ~path text)
  else if Svg_icon.is text then Svg_icon.read ~resolution ~path text
  else if begins [ "\x1f\x8b" ] then
    Picture_fault.unsupported ~path ~hint:"decompress it, by gunzip for instance" "the file is compressed"
  else if begins [ "\xff\xfe"; "\xfe\xff"; "<\000"; "\000<" ] then
    Picture_fault.unsupported ~path ~hint:"save it as UTF-8" "the text is in UTF-16, which is not read"
  else
    Picture_fault.unsupported ~path ~hint:"pictures are PNG, Netpbm (PBM, PGM, PPM) and SVG"
      "this is no picture that scc reads"

let read ?resolution ~path text = Result.map fst (read_warned ?resolution ~path text)
