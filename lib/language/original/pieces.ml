open Scc_base
open Scc_exact
open Scc_geometry

type face_of = Face of int | Seam of int
type plane = { normal : Vec.t; offset : Rat.t }
type piece = { faces : (face_of * Vec.t list) list }

let whole (p : Polyhedron.ifs) =
  let corners (_, c) = List.map (fun v -> snd p.ifs_vertices.(v)) (Array.to_list c) in
  { faces = List.mapi (fun i f -> (Face i, corners f)) (Array.to_list p.ifs_faces) }

(* Above 0 beyond the plane, in the direction of its normal. *)
let height plane x = Rat.sub (Vec.dot plane.normal x) plane.offset
let side plane x = Rat.sign (height plane x)

let is_cut plane piece =
  let some s = List.exists (fun (_, c) -> List.exists (fun x -> Int.equal (side plane x) s) c) piece.faces in
  some 1 && some (-1)

let crossing plane a b =
  let h = height plane a and k = height plane b in
  Vec.axpy (Rat.div h (Rat.sub h k)) (Vec.sub b a) a

(* What is left of a polygon on the side [s] of a plane: nothing, if no corner is strictly there. *)
let clip plane s corners =
  let rec go acc = function
    | a :: (b :: _ as rest) ->
      let sa = side plane a * s and sb = side plane b * s in
      let acc = if sa >= 0 then a :: acc else acc in
      let acc = if sa * sb < 0 then crossing plane a b :: acc else acc in
      go acc rest
    | [ _ ] | [] -> List.rev acc
  in
  match corners with
  | first :: _ when List.exists (fun x -> side plane x * s > 0) corners -> go [] (List.append corners [ first ])
  | _ -> []

(* The side of each face that lies in the plane, from its last point there to its first: the face of the seam
   runs along all of them the other way round. *)
let seam plane faces =
  let on x = side plane x = 0 in
  let along (_, corners) =
    List.filter_map (fun (a, b) -> if on a && on b then Some (b, a) else None) (Scc_data.Lists.ring corners)
  in
  match List.concat_map along faces with
  | [] -> Bug.fail __POS__ "a plane that cuts no face"
  | (start, next) :: _ as sides ->
    let rec follow acc x =
      if Vec.equal x start then List.rev acc
      else
        match List.find_opt (fun (a, _) -> Vec.equal a x) sides with
        | Some (_, y) -> follow (x :: acc) y
        | None -> Bug.fail __POS__ "a seam that is not closed"
    in
    follow [ start ] next

let half number plane s piece =
  let faces =
    List.filter_map
      (fun (f, corners) -> match clip plane s corners with [] -> None | c -> Some (f, c))
      piece.faces
  in
  { faces = (Seam number, seam plane faces) :: faces }

let cut ~most planes piece =
  let one number plane pieces =
    List.concat_map
      (fun p -> if is_cut plane p then [ half number plane (-1) p; half number plane 1 p ] else [ p ])
      pieces
  in
  let rec go number pieces = function
    | [] -> Some pieces
    | plane :: rest ->
      let pieces = one number plane pieces in
      if List.compare_length_with pieces most > 0 then None else go (number + 1) pieces rest
  in
  go 0 [ piece ] planes

let corners piece = List.sort_uniq Vec.compare (List.concat_map snd piece.faces)

let ifs piece ~vertex ~face =
  let places = Array.of_list (corners piece) in
  let index x =
    let rec find low high =
      let middle = (low + high) / 2 in
      let c = Vec.compare x places.(middle) in
      if c = 0 then middle else if c < 0 then find low (middle - 1) else find (middle + 1) high
    in
    find 0 (Array.length places - 1)
  in
  {
    Polyhedron.ifs_vertices = Array.mapi (fun i x -> (vertex i, x)) places;
    ifs_faces =
      Array.of_list (List.map (fun (f, c) -> (face f, Array.of_list (List.map index c))) piece.faces);
  }

let joints pieces =
  let n = Array.length pieces in
  let root = Array.init n Fun.id in
  let rec find i = if root.(i) = i then i else find root.(i) in
  let seams p =
    List.filter_map
      (function Seam k, c -> Some (k, List.sort Vec.compare c) | Face _, _ -> None)
      p.faces
  in
  let all = Array.map seams pieces in
  let found = ref [] in
  for i = 0 to n - 1 do
    for j = i + 1 to n - 1 do
      List.iter
        (fun (k, c) ->
           let same (k', c') = Int.equal k k' && List.equal Vec.equal c c' in
           if (not (Int.equal (find i) (find j))) && List.exists same all.(j) then begin
             root.(find j) <- find i;
             found := (i, j, k) :: !found
           end)
        all.(i)
    done
  done;
  List.rev !found

(* Of the tetrahedra that a corner spans with the triangles of the faces. *)
let volume piece =
  let origin = match piece.faces with (_, x :: _) :: _ -> x | _ -> Vec.zero in
  let arm x = Vec.sub x origin in
  let rec fan a sum = function
    | b :: (c :: _ as rest) -> fan a (Rat.add sum (Vec.dot (arm a) (Vec.cross (arm b) (arm c)))) rest
    | [ _ ] | [] -> sum
  in
  let of_face sum (_, corners) = match corners with [] -> sum | a :: rest -> fan a sum rest in
  Rat.div (List.fold_left of_face Rat.zero piece.faces) (Rat.of_int 6)
