open Scc_base

let start path = Span.of_file path
let malformed ~path format =
  Printf.ksprintf (fun m -> Error (Diag.error Code.bad_picture (start path) "%s" m)) format

let unsupported ~path ?hint format =
  Printf.ksprintf (fun m -> Error (Diag.error ?hint Code.picture_format (start path) "%s" m)) format

let check_size ?cure ~path ~width ~height () =
  if width < 1 || height < 1 then malformed ~path "the picture has no pixels"
  else if Raster.too_large ~width ~height then
    Error
      (Diag.error Code.picture_too_large (start path)
         ~hint:
           (Printf.sprintf "%s: at most %d pixels, and no side longer than %d"
              (Option.value cure ~default:"make it smaller") Raster.max_pixels Raster.max_side)
         "the picture has %d x %d pixels, which are too many" width height)
  else Ok ()
