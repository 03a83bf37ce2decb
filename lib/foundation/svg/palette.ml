(* P. Tol's scheme {e bright}, and some more. *)
let palette =
  [| "#4477aa"; "#ee6677"; "#228833"; "#ccbb44"; "#aa3377"; "#66ccee"; "#ee7733"; "#009988"; "#9977cc";
     "#997700" |]

(* Beyond the palette, hues that are far from each other: multiples of 137 degrees. *)
let further i = Printf.sprintf "hsl(%d, 55%%, 50%%)" (i * 137 mod 360)
let colour i = if i < Array.length palette then palette.(i) else further i

type rgb = float * float * float

let white = (1., 1., 1.)
let black = (0., 0., 0.)

(* The first are M. Okabe's and K. Ito's, for people who confuse some colours. *)
let bodies =
  [| (0.90, 0.62, 0.0); (0.34, 0.71, 0.91); (0.0, 0.62, 0.45); (0.84, 0.37, 0.0); (0.80, 0.47, 0.65);
     (0.0, 0.45, 0.70); (0.88, 0.82, 0.26); (0.55, 0.42, 0.85); (0.60, 0.60, 0.60); (0.70, 0.25, 0.35) |]

let body i = bodies.(i mod Array.length bodies)

let mix (r, g, b) (r', g', b') x =
  let of_both a b = a +. (x *. (b -. a)) in
  (of_both r r', of_both g g', of_both b b')

let hex (r, g, b) =
  let byte x = int_of_float (Float.max 0. (Float.min 255. (Float.round (x *. 255.)))) in
  Printf.sprintf "#%02x%02x%02x" (byte r) (byte g) (byte b)
