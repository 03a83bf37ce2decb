(* Random sets of faces: the check of templates against E0 to E5 word by word, on hulls, on what comes of them
   by small changes, and on plain noise. *)
open Scc_exact
open Scc_geometry
module G = QCheck2.Gen

type set = { points : Vec.t array; faces : int array array }

let to_ifs s =
  let name prefix = Array.mapi (fun i x -> (prefix ^ string_of_int i, x)) in
  { Polyhedron.ifs_vertices = name "v" s.points; ifs_faces = name "f" s.faces }

let print s =
  let ints a = String.concat " " (List.map string_of_int (Array.to_list a)) in
  String.concat "\n"
    (Array.to_list (Array.map Vec.to_string s.points) @ Array.to_list (Array.map ints s.faces))

(* {1 E0 to E5, word by word} *)

let indices a = List.init (Array.length a) Fun.id
let next a i = a.((i + 1) mod Array.length a)

let directed s =
  List.concat_map (fun f -> List.map (fun i -> (f.(i), next f i)) (indices f)) (Array.to_list s.faces)

let same_edge (a, b) (c, d) = a = c && b = d

let rec all_different same = function
  | [] -> true
  | x :: rest -> (not (List.exists (same x) rest)) && all_different same rest

let plane s f =
  let p i = s.points.(f.(i)) in
  Vec.cross (Vec.sub (p 1) (p 0)) (Vec.sub (p 2) (p 0))

let height s f v = Rat.sign (Vec.dot (plane s f) (Vec.sub s.points.(v) s.points.(f.(0))))

(* Planar, and every other corner strictly to the left of each side. *)
let strictly_convex s f =
  let n = plane s f in
  let left i v =
    let a = s.points.(f.(i)) and b = s.points.(next f i) in
    Rat.sign (Vec.dot n (Vec.cross (Vec.sub b a) (Vec.sub s.points.(v) a))) > 0
  in
  (not (Vec.is_zero n))
  && all_different Int.equal (Array.to_list f)
  && Array.for_all (fun v -> height s f v = 0) f
  && List.for_all (fun i -> Array.for_all (fun v -> v = f.(i) || v = next f i || left i v) f) (indices f)

let e_holds s =
  let vertices = indices s.points and edges = directed s in
  let listed f v = Array.exists (Int.equal v) f in
  let sound f = Array.length f >= 3 && Array.for_all (fun v -> v >= 0 && v < Array.length s.points) f in
  Array.length s.faces > 0
  && Array.for_all sound s.faces
  && Array.for_all (strictly_convex s) s.faces
  && Array.for_all (fun f -> List.exists (fun v -> height s f v < 0) vertices) s.faces
  && all_different same_edge edges
  && List.for_all (fun (v, w) -> List.exists (same_edge (w, v)) edges) edges
  && all_different Vec.equal (Array.to_list s.points)
  && List.for_all (fun v -> Array.exists (fun f -> listed f v) s.faces) vertices
  && Array.for_all
    (fun f -> List.for_all (fun v -> listed f v || height s f v < 0) vertices)
    s.faces

let accepted s = Result.is_ok (Polyhedron.of_ifs (to_ifs s))

(* {1 Hulls} *)

let spatial points =
  match points with
  | a :: rest ->
    let d = List.map (fun p -> Vec.sub p a) rest in
    List.exists
      (fun u ->
         List.exists
           (fun v -> List.exists (fun w -> Rat.sign (Vec.dot u (Vec.cross v w)) <> 0) d)
           d)
      d
  | [] -> false

let hull points =
  let s = Scc_naive.Naive.hull points in
  { points = s.points; faces = Array.of_list (List.map Array.of_list s.faces) }

let cube_points =
  let ends = [ -1; 1 ] in
  List.concat_map (fun x -> List.concat_map (fun y -> List.map (Vec.of_ints x y) ends) ends) ends

let small = G.int_range (-3) 3
let point = G.map3 Vec.of_ints small small small

let some_hull =
  let make points = hull (if spatial points then points else cube_points) in
  G.map make (G.list_size (G.int_range 4 10) point)

let reversed s =
  let reverse f = Array.of_list (List.rev (Array.to_list f)) in
  { s with faces = Array.map reverse s.faces }

(* {1 Small changes} *)

type change =
  | Move of int * Vec.t
  | Drop of int
  | Twice of int
  | Turn of int
  | Swap of int * int
  | Rename of int * int * int
  | Cut of int  (* a face of four corners or more in two *)
  | Spare of Vec.t

let change =
  let index = G.int_bound 1000 in
  G.oneof
    [
      G.map2 (fun i d -> Move (i, d)) index point;
      G.map (fun i -> Drop i) index;
      G.map (fun i -> Twice i) index;
      G.map (fun i -> Turn i) index;
      G.map2 (fun i j -> Swap (i, j)) index index;
      G.map3 (fun i j k -> Rename (i, j, k)) index index index;
      G.map (fun i -> Cut i) index;
      G.map (fun p -> Spare p) point;
    ]

let put a i x = Array.mapi (fun j y -> if i = j then x else y) a

let apply s change =
  let faces = Array.length s.faces in
  let face i = s.faces.(i mod faces) in
  let with_face i f = { s with faces = put s.faces (i mod faces) f } in
  if faces = 0 then s
  else
    match change with
    | Move (i, d) ->
      let i = i mod Array.length s.points in
      { s with points = put s.points i (Vec.add s.points.(i) d) }
    | Drop i ->
      let others = List.filteri (fun j _ -> j <> i mod faces) (Array.to_list s.faces) in
      { s with faces = Array.of_list others }
    | Twice i -> { s with faces = Array.append s.faces [| face i |] }
    | Turn i -> with_face i (Array.of_list (List.rev (Array.to_list (face i))))
    | Swap (i, j) ->
      let f = face i in
      let n = Array.length f in
      let a = j mod n and b = (j + 1) mod n in
      with_face i (put (put f a f.(b)) b f.(a))
    | Rename (i, j, k) ->
      let f = face i in
      with_face i (put f (j mod Array.length f) (k mod Array.length s.points))
    | Cut i when Array.length (face i) > 3 ->
      let f = face i in
      let n = Array.length f in
      let changed = with_face i (Array.sub f 0 3) in
      let rest = Array.append [| f.(0) |] (Array.sub f 2 (n - 2)) in
      { changed with faces = Array.append changed.faces [| rest |] }
    | Cut _ -> s
    | Spare p -> { s with points = Array.append s.points [| p |] }

let changed_hull = G.map2 (List.fold_left apply) some_hull (G.list_size (G.int_range 1 2) change)

let noise =
  let face = G.map Array.of_list (G.list_size (G.int_range 3 4) (G.int_bound 4)) in
  let make points faces = { points = Array.of_list points; faces = Array.of_list faces } in
  G.map2 make (G.list_repeat 5 point) (G.list_size (G.int_range 0 8) face)

(* {1 Properties} *)

let law name ?(count = 1000) gen holds = QCheck2.Test.make ~name ~count ~print gen holds

let hulls_accepted = law "hulls are accepted" some_hull (fun s -> e_holds s && accepted s)
let as_written name gen = law name ~count:3000 gen (fun s -> Bool.equal (e_holds s) (accepted s))

let implies_paper =
  law "what is accepted passes the seven conditions" some_hull (fun s ->
      let paper = Definition_4_3.check (to_ifs s) in
      (not (accepted s)) || (Definition_4_3.holds paper && Definition_4_3.euler paper = 2))

let inside_out =
  law "a hull inside out has one fault" some_hull (fun s ->
      match Polyhedron.of_ifs (to_ifs (reversed s)) with
      | Error [ Inward ] -> true
      | Error _ | Ok _ -> false)

let side_by_side s t =
  let far = Array.map (Vec.add (Vec.of_ints 50 0 0)) t.points in
  let faces = Array.map (Array.map (fun v -> v + Array.length s.points)) t.faces in
  { points = Array.append s.points far; faces = Array.append s.faces faces }

let two_hulls =
  law "two hulls apart are separate solids" (G.map2 side_by_side some_hull some_hull) (fun s ->
      match Polyhedron.of_ifs (to_ifs s) with
      | Error [ Separate_solids (0, _) ] -> true
      | Error _ | Ok _ -> false)

let without_a_face =
  law "a missing face leaves open edges only" (G.map (fun s -> apply s (Drop 0)) some_hull) (fun s ->
      let opens = function
        | Polyhedron_fault.Open_edge _ | Unused_vertex _ -> true
        | _ -> false
      in
      match Polyhedron.of_ifs (to_ifs s) with
      | Error faults -> List.for_all opens faults
      | Ok _ -> false)

let turned_face =
  law "a turned face is named" (G.map (fun s -> apply s (Turn 1)) some_hull) (fun s ->
      match Polyhedron.of_ifs (to_ifs s) with
      | Error [ Turned_face (1, _) ] -> true
      | Error faults ->
        (* In a tetrahedron three may as well be called turned; never more than half. *)
        2 * List.length faults <= Array.length s.faces
      | Ok _ -> false)

(* The corners of the largest face in another order, which is neither way round. *)
let out_of_order =
  let largest s =
    let better f g = if Array.length s.faces.(g) > Array.length s.faces.(f) then g else f in
    List.fold_left better 0 (indices s.faces)
  in
  let rotations a = List.map (fun k -> Array.mapi (fun i _ -> a.((i + k) mod Array.length a)) a) (indices a) in
  let shuffle s seed =
    let f = largest s in
    let order v w = Int.compare (Hashtbl.hash (seed, v)) (Hashtbl.hash (seed, w)) in
    let corners = Array.of_list (List.sort order (Array.to_list s.faces.(f))) in
    (s, f, corners)
  in
  let print (s, f, corners) =
    Printf.sprintf "%s\nface %d as %s" (print s) f
      (String.concat " " (List.map string_of_int (Array.to_list corners)))
  in
  let reverse a = Array.of_list (List.rev (Array.to_list a)) in
  QCheck2.Test.make ~name:"a face with its corners out of order is one fault, which gives the order"
    ~count:1000 ~print
    (G.map2 shuffle some_hull G.nat)
    (fun (s, f, corners) ->
       let ways = rotations s.faces.(f) in
       let right = List.find (fun a -> a.(0) = corners.(0)) ways in
       let faces = Array.mapi (fun i face -> if i = f then corners else face) s.faces in
       List.mem corners ways
       || List.mem (reverse corners) ways
       ||
       match Polyhedron.of_ifs (to_ifs { s with faces }) with
       | Error [ (Self_crossing (g, Some order) as fault) ] ->
         g = f && order = right
         && (Polyhedron_fault.hint ~vertex:string_of_int ~face:string_of_int fault <> None)
       | Error _ | Ok _ -> false)

let affine =
  let gen = G.triple some_hull (G.map3 Mat.make point point point) point in
  QCheck2.Test.make ~name:"affine images of positive determinant, and no reflections" ~count:500
    ~print:(fun (s, _, _) -> print s)
    gen
    (fun (s, m, d) ->
       let image = { s with points = Array.map (fun p -> Vec.add d (Mat.apply m p)) s.points } in
       Bool.equal (accepted image) (Rat.sign (Mat.det m) > 0))

let witnesses =
  law "witnesses are true" ~count:2000 changed_hull (fun s ->
      let holds : Polyhedron_fault.t -> bool = function
        | Not_convex (f, v) -> height s s.faces.(f) v > 0
        | In_plane (f, v) -> height s s.faces.(f) v = 0 && not (Array.exists (Int.equal v) s.faces.(f))
        | Open_edge (f, v, w) ->
          List.exists (fun i -> s.faces.(f).(i) = v && next s.faces.(f) i = w) (indices s.faces.(f))
        | Same_position (v, w) -> v <> w && Vec.equal s.points.(v) s.points.(w)
        | Unused_vertex v -> not (Array.exists (Array.exists (Int.equal v)) s.faces)
        | _ -> true
      in
      match Polyhedron.of_ifs (to_ifs s) with
      | Ok _ -> true
      | Error faults ->
        (* Faults of an inside-out or welded set, or of a face out of order, are those of the set as mended. *)
        let mended = function
          | Polyhedron_fault.Inward | Same_position _ | Self_crossing (_, Some _) -> true
          | _ -> false
        in
        faults <> [] && (List.exists mended faults || List.for_all holds faults))

let suite =
  ("random solids",
   [
     ( "Def-4.3",
       Scc_test_support.Property.cases
         [
           hulls_accepted; implies_paper; inside_out; two_hulls; without_a_face; turned_face; out_of_order; affine;
           witnesses;
           as_written "changed hulls: E0 to E5 as written" changed_hull;
           as_written "noise: E0 to E5 as written" noise;
         ] );
   ])
