open Scc_exact

type t = Finite of Rat.t | Infinite | Not_computed

(* {1 By corners}

   For an objective c that is constant along no edge, the volume is the sum over all corners v of

   (c.v)^n / (n! |det| g_1 ... g_n)

   where c is g_1 a_1 + ... + g_n a_n for the normals a_i that meet at v, with the determinant det. It is a
   polynomial in where the facets are as long as the same ones meet: so what is true of facets moved a little is
   true of them. *)

let most_corners = 20_000

let rec power x n = if n = 0 then Rat.one else Rat.mul x (power x (n - 1))

let factorial n =
  List.fold_left (fun product k -> Rat.mul product (Rat.of_int (k + 1))) Rat.one (List.init n Fun.id)

(* Objectives of numbers that look like no others, each for one attempt. *)
let objective n attempt =
  let rec numbers k seed = if k = 0 then [] else seed :: numbers (k - 1) (((seed * 1103) + 12345) mod 65537) in
  Array.of_list (List.map (fun s -> Rat.of_int (1 + (s mod 997))) (numbers n (7919 + attempt)))

type sum = Sum of Rat.t | Constant_along_an_edge

let rec by_corners p attempt =
  let n = Polyhedron.dimension p in
  let c = objective n attempt in
  let add sum (corner : Corners.t) =
    match sum with
    | Constant_along_an_edge -> sum
    | Sum sum ->
      let slopes = corner.slopes c in
      if List.exists (fun g -> Rat.sign g = 0) slopes then Constant_along_an_edge
      else
        let height = ref Rat.zero in
        Array.iteri (fun i x -> height := Rat.add !height (Rat.mul c.(i) x)) corner.point;
        let by = List.fold_left Rat.mul (Q.of_bigint corner.determinant) slopes in
        Sum (Rat.add sum (Rat.div (power !height n) by))
  in
  match Corners.fold ~most:most_corners add (Sum Rat.zero) p with
  | None -> Not_computed
  | Some (Sum sum) -> Finite (Rat.div sum (factorial n))
  | Some Constant_along_an_edge -> by_corners p (attempt + 1)

(* {1 By blocks} *)

(* Variables that no constraint has together, directly or by others: the polyhedron is the product of what it is in
   each block of variables, and a box is quick in any dimension. *)
let blocks n constraints =
  let add blocks c =
    let has i = Constraint.mentions c i in
    let touched, others = List.partition (List.exists has) blocks in
    match touched with [] -> others | _ :: _ -> List.concat touched :: others
  in
  List.fold_left add (List.init n (fun i -> [ i ])) constraints

let of_block p block =
  let onto = Array.of_list (List.sort Int.compare block) in
  let at = Array.make (Polyhedron.dimension p) 0 in
  Array.iteri (fun k i -> at.(i) <- k) onto;
  let m = Array.length onto in
  let about c = List.exists (Constraint.mentions c) block in
  let own = List.filter about (Polyhedron.constraints p) in
  by_corners (Polyhedron.of_constraints m (List.map (fun c -> Constraint.rename c ~dimension:m at) own)) 0

let map2 op a b =
  match (a, b) with
  | Finite a, Finite b -> Finite (op a b)
  | Infinite, _ | _, Infinite -> Infinite
  | Not_computed, _ | _, Not_computed -> Not_computed

let of_polyhedron p =
  let n = Polyhedron.dimension p in
  if Polyhedron.affine_dimension p < n then Finite Rat.zero
  else if Polyhedron.is_bounded p then
    let volumes = List.map (of_block p) (blocks n (Polyhedron.constraints p)) in
    List.fold_left (map2 Rat.mul) (Finite Rat.one) volumes
  else Infinite

let sum = List.fold_left (map2 Rat.add) (Finite Rat.zero)
