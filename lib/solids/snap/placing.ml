(* An element (p, q, r, s) is the point or the plane (p, q, r)/s; two of them lie on each other when
   p p' + q q' + r r' = s s'. *)
type element = { p : Z.t; q : Z.t; r : Z.t; s : Z.t }

let entry e = function 0 -> e.p | 1 -> e.q | 2 -> e.r | _ -> e.s
let on e = { e with s = Z.neg e.s }

let det3 a b c i j k =
  let minor u v =
    Z.sub (Z.mul (entry b u) (entry c v)) (Z.mul (entry b v) (entry c u))
  in
  Z.add
    (Z.sub (Z.mul (entry a i) (minor j k)) (Z.mul (entry a j) (minor i k)))
    (Z.mul (entry a k) (minor i j))

let shortest e =
  let g = Z.gcd (Z.gcd e.p e.q) (Z.gcd e.r e.s) in
  let g = if Z.sign e.s < 0 then Z.neg g else g in
  { p = Z.divexact e.p g; q = Z.divexact e.q g; r = Z.divexact e.r g; s = Z.divexact e.s g }

(* The one element on which all three rows vanish; none where that is at infinity, or there are more. *)
let meet a b c =
  let e =
    {
      p = det3 a b c 1 2 3; q = Z.neg (det3 a b c 0 2 3); r = det3 a b c 0 1 3;
      s = Z.neg (det3 a b c 0 1 2);
    }
  in
  if Z.sign e.s = 0 then None else Some (shortest e)

(* {1 Free coordinates} *)

let rounded grid x = Z.of_float (Float.round (ldexp x grid))

(* The row that fixes a coordinate at its place on the grid. *)
let fixed grid (at : float array) k =
  let one i = if i = k then Z.shift_left Z.one grid else Z.zero in
  { p = one 0; q = one 1; r = one 2; s = Z.neg (rounded grid at.(k)) }

let greatest v =
  let a = Array.map Float.abs v in
  if a.(0) >= a.(1) && a.(0) >= a.(2) then 0 else if a.(1) >= a.(2) then 1 else 2

let cross a b =
  (* as in Polish, the same on all machines *)
  let times x y = Sys.opaque_identity (x *. y) in
  let m i j = times a.(i) b.(j) -. times a.(j) b.(i) in
  [| m 1 2; m 2 0; m 0 1 |]

type guess = int -> float array

let element ~grid (guess : guess) known u earlier =
  let at = guess u in
  let fixed = fixed grid at in
  let row w = on (known w) in
  match earlier with
  | [||] ->
    let on_grid k = rounded grid at.(k) in
    Some (shortest { p = on_grid 0; q = on_grid 1; r = on_grid 2; s = Z.shift_left Z.one grid })
  | [| a |] ->
    let k = greatest (guess a) in
    meet (row a) (fixed ((k + 1) mod 3)) (fixed ((k + 2) mod 3))
  | [| a; b |] -> meet (row a) (row b) (fixed (greatest (cross (guess a) (guess b))))
  | [| a; b; c |] -> meet (row a) (row b) (row c)
  | _ -> Scc_base.Bug.fail __POS__ "an element on more than three earlier ones"

let place (order : Order.t) ~grid guess ~keep =
  let n = Array.length order.placed in
  let found = Array.make n None in
  let known w = Option.get found.(w) in
  let rec go k =
    if k = n then Some (Array.map Option.get found)
    else
      let u = order.placed.(k) in
      match element ~grid guess known u order.earlier.(k) with
      | Some e when keep u e ->
        found.(u) <- Some e;
        go (k + 1)
      | Some _ | None -> None
  in
  go 0

let coordinate e k = Q.make (entry e k) e.s
let vector e = Scc_exact.Vec.make (coordinate e 0) (coordinate e 1) (coordinate e 2)
