open Scc_exact
open Scc_polyhedra

type point = { x : Rat.t; y : Rat.t }

let compare a b =
  Rat.compare a.x b.x <?> fun () -> Rat.compare a.y b.y

let midpoint a b = { x = Rat.middle a.x b.x; y = Rat.middle a.y b.y }
let mem u p = Union.mem u [| p.x; p.y |]
let normal (c : Constraint.t) = (Q.of_bigint c.normal.(0), Q.of_bigint c.normal.(1))
let dot (a, b) (x, y) = Rat.add (Rat.mul a x) (Rat.mul b y)

(* How far inside of the border of the constraint the point is. *)
let slack (c : Constraint.t) p = Rat.sub (Q.of_bigint c.right) (dot (normal c) (p.x, p.y))

let satisfied (c : Constraint.t) p =
  let sign = Rat.sign (slack c p) in
  if c.relation = Equal then sign = 0 else sign >= 0

let in_closure p point = List.for_all (fun c -> satisfied c point) (Polyhedron.constraints p)

(* Cramer's rule. *)
let crossing (c : Constraint.t) (d : Constraint.t) =
  let a, b = normal c and a', b' = normal d in
  let determinant = Rat.sub (Rat.mul a b') (Rat.mul a' b) in
  if Rat.sign determinant = 0 then None
  else
    let r = Q.of_bigint c.right and r' = Q.of_bigint d.right in
    Some
      {
        x = Rat.div (Rat.sub (Rat.mul r b') (Rat.mul r' b)) determinant;
        y = Rat.div (Rat.sub (Rat.mul a r') (Rat.mul a' r)) determinant;
      }

(* Around a point inside: the upper half turn first, starting to the right. *)
let around center points =
  let from p = (Rat.sub p.x center.x, Rat.sub p.y center.y) in
  let half (x, y) = if Rat.sign y > 0 || (Rat.sign y = 0 && Rat.sign x > 0) then 0 else 1 in
  let before p q =
    let (x, y) as u = from p and (x', y') as v = from q in
    if half u <> half v then Int.compare (half u) (half v) else Rat.sign (Rat.sub (Rat.mul x' y) (Rat.mul x y'))
  in
  List.sort before points

let center points =
  let share = Rat.make Z.one (Z.of_int (List.length points)) in
  let sum = List.fold_left (fun s p -> { x = Rat.add s.x p.x; y = Rat.add s.y p.y }) in
  let total = sum { x = Rat.zero; y = Rat.zero } points in
  { x = Rat.mul share total.x; y = Rat.mul share total.y }

let corners p =
  let constraints = Polyhedron.constraints p in
  let crossings = List.filter_map (fun (c, d) -> crossing c d) (Scc_data.Lists.pairs constraints) in
  let found = List.sort_uniq compare (List.filter (in_closure p) crossings) in
  if List.compare_length_with found 2 <= 0 then found else around (center found) found

let along (a, b) t =
  let at u v = Rat.add u (Rat.mul t (Rat.sub v u)) in
  { x = at a.x b.x; y = at a.y b.y }

(* On the way the slack of a half-space is s (1 - t) + s' t, with those at its ends. *)
let cut (a, b) (c : Constraint.t) (low, high) =
  let s = slack c a and s' = slack c b in
  let falls = Rat.sub s s' in
  let sign = Rat.sign falls in
  if sign = 0 then
    let right = if c.relation = Equal then Rat.sign s = 0 else Rat.sign s >= 0 in
    if right then Some (low, high) else None
  else
    let t = Rat.div s falls in
    let low = if c.relation = Equal || sign < 0 then Rat.max low t else low in
    let high = if c.relation = Equal || sign > 0 then Rat.min high t else high in
    if Rat.compare low high <= 0 then Some (low, high) else None

let meets_at p segment =
  let cut range (c : Constraint.t) = Option.bind range (cut segment c) in
  match List.fold_left cut (Some (Rat.zero, Rat.one)) (Polyhedron.constraints p) with
  | None -> []
  | Some (low, high) -> [ low; high ]

let reaches_beyond p point ~towards =
  let inside (c : Constraint.t) =
    match Rat.sign (slack c point) with
    | 0 -> c.relation <> Equal && Rat.sign (dot (normal c) towards) < 0
    | sign -> sign > 0
  in
  List.for_all inside (Polyhedron.constraints p)
