type t = { width : int; height : int; colours : int array; alphas : Bytes.t }

let max_side = 2048
let max_pixels = 1 lsl 18

let too_large ~width ~height =
  width > max_side || height > max_side || width * height > max_pixels

let create ~width ~height =
  let n = width * height in
  { width; height; colours = Array.make n 0; alphas = Bytes.make n '\000' }

let colour_text = Printf.sprintf "#%06x"
