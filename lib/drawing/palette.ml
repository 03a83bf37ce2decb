(* P. Tol's scheme {e bright}, and some more. *)
let palette =
  [| "#4477aa"; "#ee6677"; "#228833"; "#ccbb44"; "#aa3377"; "#66ccee"; "#ee7733"; "#009988"; "#9977cc";
     "#997700" |]

(* Beyond the palette, hues that are far from each other: multiples of 137 degrees. *)
let hue i = i * 137 mod 360
let colour i = if i < Array.length palette then palette.(i) else Printf.sprintf "hsl(%d, 55%%, 50%%)" (hue i)

type rgb = float * float * float

let white = (1., 1., 1.)
let black = (0., 0., 0.)

(* hsl(hue, 55 %, 50 %). *)
let of_hue hue =
  let channel shift =
    let k = Float.rem (shift +. (float_of_int hue /. 30.)) 12. in
    0.5 -. (0.55 *. 0.5 *. Float.max (-1.) (Float.min (Float.min (k -. 3.) (9. -. k)) 1.))
  in
  (channel 0., channel 8., channel 4.)

let of_hex text =
  let at i = float_of_int (int_of_string ("0x" ^ String.sub text i 2)) /. 255. in
  (at 1, at 3, at 5)

let rgb i = if i < Array.length palette then of_hex palette.(i) else of_hue (hue i)

let mix (r, g, b) (r', g', b') x =
  let of_both a b = a +. (x *. (b -. a)) in
  (of_both r r', of_both g g', of_both b b')

let hex (r, g, b) =
  let byte x = int_of_float (Float.max 0. (Float.min 255. (Float.round (x *. 255.)))) in
  Printf.sprintf "#%02x%02x%02x" (byte r) (byte g) (byte b)
