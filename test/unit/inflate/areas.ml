(* Pictures of SVG against areas that are given by formulas. *)
open Scc_base
open Scc_pixels

let read ?(resolution = 160) text = Icon.read ~resolution ~path:"icon" text

let ok ?resolution name text =
  match read ?resolution text with
  | Ok r -> r
  | Error d -> Alcotest.failf "%s: %s" name d.Diag.message

let code text = match read ~resolution:16 text with Ok _ -> "read" | Error d -> (d.code :> string)

let svg ?(box = "0 0 40 30") body =
  Printf.sprintf
    "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
     viewBox=\"%s\">%s</svg>" box body

let inside (r : Raster.t) x y = Bytes.get_uint8 r.alphas ((y * r.width) + x) <> 0

(* {1 Areas} *)

(* [value x y], less than 0 inside, has at most the slope 1: centres nearer than 1/32 pixel to the line may be on
   either side. Four pixels are one unit. *)
let area name body value =
  let r = ok name (svg body) in
  Alcotest.(check (pair int int)) name (160, 120) (r.width, r.height);
  for y = 0 to 119 do
    for x = 0 to 159 do
      let v = 4. *. value ((float_of_int x +. 0.5) /. 4.) ((float_of_int y +. 0.5) /. 4.) in
      if Float.abs v > 1. /. 32. && inside r x y <> (v < 0.) then Alcotest.failf "%s: pixel %d, %d" name x y
    done
  done

let circle x0 y0 r x y = Float.hypot (x -. x0) (y -. y0) -. r
let box x0 y0 x1 y1 x y = Float.max (Float.max (x0 -. x) (x -. x1)) (Float.max (y0 -. y) (y -. y1))
let union f g x y = Float.min (f x y) (g x y)
let both f g x y = Float.max (f x y) (g x y)
let without f g x y = Float.max (f x y) (-.g x y)
let any areas = List.fold_left union (fun _ _ -> infinity) areas
let ring x0 y0 r half x y = Float.abs (circle x0 y0 r x y) -. half

(* Around a segment: with flat ends, and with round ones. *)
let frame (ax, ay) (bx, by) x y =
  let dx = bx -. ax and dy = by -. ay in
  let l = Float.hypot dx dy in
  (((x -. ax) *. dx) +. ((y -. ay) *. dy)) /. l, (((y -. ay) *. dx) -. ((x -. ax) *. dy)) /. l, l

let bar a b half x y =
  let along, across, l = frame a b x y in
  Float.max (Float.max (-.along) (along -. l)) (Float.abs across -. half)

let capsule a b half x y =
  let along, across, l = frame a b x y in
  Float.hypot (Float.max 0. (Float.max (-.along) (along -. l))) across -. half

(* The half plane to the left of a directed line, as the screen has it: to the right. *)
let beside a b x y =
  let _, across, _ = frame a b x y in
  -.across

let polygon corners =
  let n = List.length corners in
  let edges = List.mapi (fun i a -> beside a (List.nth corners ((i + 1) mod n))) corners in
  List.fold_left both (fun _ _ -> neg_infinity) edges
