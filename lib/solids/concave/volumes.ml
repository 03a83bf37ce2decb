open Scc_exact
open Scc_geometry

let primes = List.map (fun k -> Z.pred (Z.shift_left Z.one k)) [ 61; 89; 107; 127 ]

exception Divides

let residue p (q : Rat.t) =
  if Z.equal q.den Z.one then Z.erem q.num p
  else
    let d = Z.erem q.den p in
    if Z.sign d = 0 then raise_notrace Divides;
    Z.erem (Z.mul (Z.erem q.num p) (Z.invert d p)) p

let point p (v : Vec.t) = Ivec.make (residue p v.x) (residue p v.y) (residue p v.z)

let six_fold p vertices faces =
  let points = Array.map (fun (_, x) -> point p x) vertices in
  let of_face sum (_, face) =
    let at k = points.(face.(k)) in
    let sum = ref sum in
    for k = 1 to Array.length face - 2 do
      sum := Z.erem (Z.add !sum (Ivec.det (at 0) (at k) (at (k + 1)))) p
    done;
    !sum
  in
  Array.fold_left of_face Z.zero faces

let agree p (surface : Polyhedron.ifs) parts =
  let of_part sum (part : Polyhedron.t) = Z.add sum (six_fold p part.vertices part.faces) in
  let sum = List.fold_left of_part Z.zero parts in
  Z.divisible (Z.sub sum (six_fold p surface.ifs_vertices surface.ifs_faces)) p

let exactly surface parts =
  let volume (p : Polyhedron.t) = (Mass_properties.of_polyhedron p).volume in
  Rat.equal (Drawn.volume surface) (List.fold_left (fun sum p -> Rat.add sum (volume p)) Rat.zero parts)

let equal surface parts =
  let rec with_prime = function
    | [] -> exactly surface parts
    | p :: rest -> ( match agree p surface parts with exception Divides -> with_prime rest | same -> same)
  in
  with_prime primes
