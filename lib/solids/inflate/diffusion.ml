open Scc_base
open Scc_exact

type t = { values : int array; bits : int; error : int }

(* Eight times a bound on the solution for 4 s = 1: (m + 1)^2, with m the smaller one of width and height. *)
let bound (s : Silhouette.t) =
  let m = min s.width s.height - 2 in
  (m + 1) * (m + 1)

(* Values are at most bound / 2, times 2^bits. Relaxation goes beyond them on its way: sums of four have room for
   sixteen times as much. *)
let bits_of bound =
  let rec log n = if n <= 1 then 0 else 1 + log ((n + 1) / 2) in
  min 40 (55 - log bound)

(* {1 Relaxation} *)

let omega_bits = 16

(* The factor that is about the best one: that of the rectangle, or of a long strip three times as wide as the
   largest disc in the shape, which is enough for thin shapes. Any factor between 1 and 2 leads to the same
   solution, and this one is computed without functions that differ between machines: the sine of pi/(m + 1) by
   its series. *)
let omega (s : Silhouette.t) =
  let inverse n = 1. /. float_of_int (n * n) in
  let rectangle = (inverse (s.width - 1) +. inverse (s.height - 1)) /. 2. in
  let strip = 1. /. (2. *. 9. *. float_of_int (Silhouette.depth s)) in
  let x = 3.14159265358979 *. sqrt (Float.max rectangle strip) in
  let sine = x *. (1. -. (x *. x /. 6.) +. (x *. x *. x *. x /. 120.)) in
  int_of_float (2. /. (1. +. sine) *. float_of_int (1 lsl omega_bits))

type system = {
  indices : int array;  (** of the pixels of the shape, in the rectangle *)
  right : int array;  (** 4 s, of each of these *)
  values : int array;  (** of all of the rectangle, 0 outside of the shape *)
  width : int;
}

let left_over y k =
  let i = y.indices.(k) in
  let v = y.values in
  y.right.(k) + v.(i - 1) + v.(i + 1) + v.(i - y.width) + v.(i + y.width) - (4 * v.(i))

(* The greatest of what was left over before each step. *)
let sweep y omega =
  let shift = omega_bits + 2 in
  let mask = (1 lsl shift) - 1 in
  let greatest = ref 0 in
  for k = 0 to Array.length y.indices - 1 do
    let r = left_over y k in
    (* (omega r) / 2^shift, to the nearest, where the product may be too large. *)
    let step = ((r asr shift) * omega) + ((((r land mask) * omega) + (1 lsl (shift - 1))) asr shift) in
    let i = y.indices.(k) in
    y.values.(i) <- y.values.(i) + step;
    if abs r > !greatest then greatest := abs r
  done;
  !greatest

let greatest_left_over y =
  let greatest = ref 0 in
  for k = 0 to Array.length y.indices - 1 do
    greatest := max !greatest (abs (left_over y k))
  done;
  !greatest

(* Ends when rounding keeps it from coming nearer, with a few plain sweeps (Gauss and Seidel) to smooth what
   over-relaxation leaves. *)
let relax ~progress ~bits y omega =
  let start = float_of_int (bits + 2) and best = ref max_int and stuck = ref 0 and most = ref 200_000 in
  while !best > 4 && !stuck < 400 && !most > 0 do
    let r = sweep y omega in
    if r < !best then begin
      best := r;
      stuck := 0
    end
    else incr stuck;
    decr most;
    if !most land 15 = 0 then
      progress (Float.max 0. (1. -. (Float.log2 (float_of_int (max 1 !best)) /. start)))
  done;
  for _ = 1 to 8 do
    ignore (sweep y (1 lsl omega_bits))
  done

(* {1 Symmetry} *)

(* The maps of the rectangle to itself that keep the shape and its strengths, but for the identity. *)
let symmetries (s : Silhouette.t) (strengths : int array) =
  let w = s.width and h = s.height in
  let mirrored x y = (w - 1 - x, y) and turned x y = (x, h - 1 - y) in
  let half x y = (w - 1 - x, h - 1 - y) in
  let square =
    [
      (fun x y -> (y, x)); (fun x y -> (y, w - 1 - x)); (fun x y -> (w - 1 - y, x));
      (fun x y -> (w - 1 - y, w - 1 - x));
    ]
  in
  let index f i = let x, y = f (i mod w) (i / w) in (y * w) + x in
  let keeps f =
    let rec go i = i >= w * h || (strengths.(i) = strengths.(f i) && go (i + 1)) in
    go 0
  in
  List.filter keeps (List.map index ([ mirrored; turned; half ] @ if w = h then square else []))

(* The mean over each class of pixels that are images of each other; it is computed from the same numbers, in
   whatever order, for all of the class. *)
let symmetrize maps values =
  match maps with
  | [] -> values
  | _ ->
    let order = 1 + List.length maps in
    Array.mapi (fun i v -> List.fold_left (fun sum f -> sum + values.(f i)) v maps / order) values

(* {1 All of it} *)

module Numbers = Hashtbl.Make (Rat)

let solve ~progress (s : Silhouette.t) ~strength ~greatest =
  let bound = bound s in
  let bits = bits_of bound in
  let unit = Rat.make (Z.shift_left Z.one (bits + 2)) Z.one in
  let known = Numbers.create 16 in
  let right_side i =
    let q = strength i in
    match Numbers.find_opt known q with
    | Some r -> r
    | None ->
      let r = Z.to_int (Rat.round_to (Rat.div (Rat.mul q unit) greatest) ~quantum:Rat.one).num in
      Numbers.add known q r;
      r
  in
  let all = Array.make (s.width * s.height) (-1) in
  Bytes.iteri (fun i c -> if c <> '\000' then all.(i) <- right_side i) s.inside;
  let indices = Array.of_list (List.filter (fun i -> all.(i) >= 0) (List.init (Array.length all) Fun.id)) in
  let y =
    {
      indices;
      right = Array.map (fun i -> all.(i)) indices;
      values = Array.make (Array.length all) 0;
      width = s.width;
    }
  in
  relax ~progress ~bits y (omega s);
  let values = symmetrize (symmetries s all) y.values in
  (* With values in this range nothing below overflows; the exact ones are in it. *)
  let most = (bound lsl bits) / 2 in
  if Array.exists (fun v -> v < 0 || v > 2 * most) values then Bug.fail __POS__ "relaxation left its range";
  let left = greatest_left_over { y with values } in
  (* One more for the right sides, which were rounded to half a unit. *)
  { values; bits; error = ((bound * (left + 1)) + 7) / 8 }
