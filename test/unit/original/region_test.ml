(* Regions as unions of features: the translation, read back from the shapes and compounds that it writes, has
   the points of the region and no others. *)

open Scc_exact
open Scc_syntax
open Scc_original
module G = QCheck2.Gen

let q = Rat.of_int
let frac a b = Rat.div (q a) (q b)
let source text = Scc_base.Source.make ~name:"model.osc" text

let read text =
  match Original.read (source text) with
  | Ok (model, _) -> model
  | Error ds ->
    let render = Scc_base.Diag.render ~source:(fun name -> Some (Scc_base.Source.make ~name text)) in
    Alcotest.fail (String.concat "" (List.map render ds))

(* {1 The translation as sets of points} *)

let number e = match Plain.number Plain.none e with Ok q -> q | Error _ -> Alcotest.fail "no number"
let vector e = match Plain.vector Plain.none e with Ok v -> v | Error _ -> Alcotest.fail "no vector"

type solid = { points : (string * Vec.t) list; faces : (string * string list) list }

(* By the name of the part, or "" for a shape in one piece. *)
let solids name model =
  let shapes =
    List.filter_map
      (fun (i : Ast.item) ->
         match i.it with
         | Shape (h, { it = Faces (vs, fs); _ }, _) ->
           let points = List.map (fun ((n : Ast.name), v) -> (n.it, vector v)) vs in
           let faces =
             List.map (fun ((n : Ast.name), c) -> (n.it, List.map (fun (v : Ast.name) -> v.it) c)) fs
           in
           Some (h.declared.it, { points; faces })
         | _ -> None)
      model
  in
  let part (p : Ast.part) =
    let shape = match p.part_solid.it with Template r -> r.target.it | _ -> Alcotest.fail "no template" in
    let place =
      List.find_map
        (fun (a : Ast.attribute) -> match a.it with At [ { it = Translate v; _ } ] -> Some (vector v) | _ ->
             None)
        p.part_attributes
    in
    let move (n, v) = (n, Vec.add v (Option.value place ~default:Vec.zero)) in
    let s = List.assoc shape shapes in
    (p.part.it, { s with points = List.map move s.points })
  in
  let compound (i : Ast.item) =
    match i.it with
    | Compound (h, parts, _, _) when String.equal h.declared.it name -> Some (List.map part parts)
    | _ -> None
  in
  match List.find_map compound model with
  | Some parts -> parts
  | None -> [ ("", List.assoc name shapes) ]

let features model =
  let channel (i : Ast.item) =
    match i.it with
    | Behaviour (_, _, { it = Open (c, _); _ }, _) -> Some c.features
    | _ -> None
  in
  match List.find_map channel model with Some fs -> fs | None -> Alcotest.fail "no channel"

let names (p : Ast.path) = List.map (fun (s : Ast.segment) -> s.name.it) p.it

(* The corners of a feature, in order. *)
let corners solids (f : Ast.feature) =
  let in_part part name =
    let s = List.assoc part solids in
    match List.assoc_opt name s.faces with
    | Some c -> List.map (fun v -> List.assoc v s.points) c
    | None -> [ List.assoc name s.points ]
  in
  match f.it with
  | Named p -> (
      match names p with
      | [ n ] -> in_part "" n
      | [ part; n ] -> in_part part n
      | _ -> Alcotest.fail "a name of three parts")
  | Tuple (prefix, vs) ->
    let part = match prefix with None -> "" | Some p -> String.concat "." (names p) in
    List.concat_map (fun v -> match names v with [ n ] -> in_part part n | _ -> Alcotest.fail "a prefix") vs

let between a b x =
  let d = Vec.sub b a and e = Vec.sub x a in
  Vec.is_zero (Vec.cross d e) && Rat.sign (Vec.dot d e) >= 0 && Rat.compare (Vec.dot d e) (Vec.norm2 d) <= 0

let rec sides first = function
  | a :: (b :: _ as rest) -> (a, b) :: sides first rest
  | [ a ] -> [ (a, first) ]
  | [] -> []

(* In the convex polygon, segment or point; without its border if it is [only]. *)
let in_feature ~only corners x =
  match corners with
  | [ a ] -> Vec.equal a x
  | [ a; b ] -> between a b x && not (only && (Vec.equal a x || Vec.equal b x))
  | a :: b :: c :: _ ->
    let n = Vec.cross (Vec.sub b a) (Vec.sub c a) in
    Rat.sign (Vec.dot n (Vec.sub x a)) = 0
    && List.for_all
      (fun (p, r) ->
         let s = Rat.sign (Vec.dot n (Vec.cross (Vec.sub r p) (Vec.sub x p))) in
         if only then s > 0 else s >= 0)
      (sides a corners)
  | [] -> false

let has solids features x =
  List.exists (fun (m : Ast.member) -> in_feature ~only:m.only (corners solids m.feature) x) features

(* Twice the area, as a vector. *)
let area corners =
  match corners with
  | a :: rest ->
    let arm x = Vec.sub x a in
    let rec fan = function
      | b :: (c :: _ as more) -> Vec.add (Vec.cross (arm b) (arm c)) (fan more)
      | _ -> Vec.zero
    in
    fan rest
  | [] -> Vec.zero

let faces_only fs solids =
  List.filter (fun c -> List.length c > 2) (List.map (fun (m : Ast.member) -> corners solids m.feature) fs)

(* {1 Regions of the top of a box, by their coordinates} *)

let shown (x, y) = Printf.sprintf "(%s, %s, 1)" (Rat.to_string x) (Rat.to_string y)

(* A star-shaped polygon: its corners by their directions from the middle, so that it is simple. *)
let directions = [ (4, 1); (2, 3); (-1, 4); (-3, 2); (-4, -1); (-1, -3); (2, -4); (4, -2) ]

let polygon =
  G.map
    (fun radii ->
       List.map2 (fun (x, y) r -> (frac (x * r) 16, frac (y * r) 16)) directions radii
       |> List.filteri (fun i _ -> List.nth radii i > 0))
    (G.flatten_l (List.map (fun _ -> G.int_range 1 4) directions))

type region =
  | Polygon of (Rat.t * Rat.t) list
  | Half of int * int * int
  | Top
  | Inner
  | Both of region * region
  | Either of region * region
  | Without of region * region

let rec text = function
  | Polygon c -> "polygon(" ^ String.concat ", " (List.map shown c) ^ ")"
  | Half (a, b, d) -> Printf.sprintf "half((%d, %d, 0), %d/4)" a b d
  | Top -> "top"
  | Inner -> "interior(top)"
  | Both (x, y) -> "(" ^ text x ^ ") ∩ (" ^ text y ^ ")"
  | Either (x, y) -> "(" ^ text x ^ ") ∪ (" ^ text y ^ ")"
  | Without (x, y) -> "(" ^ text x ^ ") ∖ (" ^ text y ^ ")"

(* By the triangles that the sides span with the middle, which the polygon is the union of. *)
let in_polygon corners (x, y) =
  let cross (a, b) (c, d) = Rat.sub (Rat.mul a d) (Rat.mul b c) in
  let triangle (p, r) =
    let s = Rat.sign (cross p (x, y)) and t = Rat.sign (cross (x, y) r) in
    let side = cross (Rat.sub (fst r) (fst p), Rat.sub (snd r) (snd p)) (Rat.sub x (fst p), Rat.sub y (snd p)) in
    s >= 0 && t >= 0 && Rat.sign side >= 0
  in
  match corners with [] -> false | first :: _ -> List.exists triangle (sides first corners)

let rec holds r ((x, y) as p) =
  match r with
  | Polygon c -> in_polygon c p
  | Half (a, b, d) -> Rat.compare (Rat.add (Rat.mul (q a) x) (Rat.mul (q b) y)) (frac d 4) >= 0
  | Top -> true
  | Inner -> Rat.compare (Rat.abs x) Rat.one < 0 && Rat.compare (Rat.abs y) Rat.one < 0
  | Both (r, s) -> holds r p && holds s p
  | Either (r, s) -> holds r p || holds s p
  | Without (r, s) -> holds r p && not (holds s p)

let leaf =
  G.oneof
    [
      G.map (fun c -> Polygon c) polygon;
      G.map3 (fun a b d -> Half ((if a = 0 && b = 0 then 1 else a), b, d)) (G.int_range (-2) 2) (G.int_range
                                                                                                   (-2) 2)
        (G.int_range (-3) 3);
      G.return Top; G.return Inner;
    ]

let region =
  let pair make = G.map2 make leaf leaf in
  G.oneof [ leaf; pair (fun a b -> Both (a, b)); pair (fun a b -> Either (a, b)); pair (fun a b -> Without
                                                                                           (a, b)) ]

let model r =
  Printf.sprintf
    "shape Box = box(2, 2, 2)\nbehaviour Open on Box = <a, top ∩ (%s)>. nil\nprocess p = Box mass 1 [Open]"
    (text r)

let grid = List.concat_map (fun i -> List.map (fun j -> (frac i 8, frac j 8)) (List.init 17 (fun j -> j - 8)))
    (List.init 17 (fun i -> i - 8))

(* A box in one piece stays [box(2, 2, 2)], whose features the language knows. *)
let box =
  let p = Scc_geometry.Named_solids.box (q 2) (q 2) (q 2) in
  let name v = fst p.ifs_vertices.(v) in
  {
    points = Array.to_list p.ifs_vertices;
    faces = Array.to_list (Array.map (fun (n, c) -> (n, List.map name (Array.to_list c))) p.ifs_faces);
  }

let pieces model =
  if List.exists (fun (i : Ast.item) -> match i.it with Compound _ -> true | _ -> false) model then solids
      "Box" model
  else [ ("", box) ]

let points =
  QCheck2.Test.make ~count:20 ~name:"Regions: a point is in the region iff it is in a feature of it"
    ~print:text region
    (fun r ->
       match Original.read (source (model r)) with
       | Error ds ->
         (* Too many cuts, or no points at all. *)
         List.for_all (fun (d : Scc_base.Diag.t) -> List.mem d.code [ "SC0366"; "SC0360" ]) ds
         && (List.exists (fun (d : Scc_base.Diag.t) -> String.equal d.code "SC0366") ds
             || not (List.exists (holds r) grid))
       | Ok (m, _) ->
         let solids = pieces m and fs = features m in
         List.for_all
           (fun (x, y) -> Bool.equal (holds r (x, y)) (has solids fs (Vec.make x y Rat.one)))
           grid)

(* The formula of areas by coordinates. *)
let area_of corners =
  match corners with
  | [] -> Rat.zero
  | first :: _ ->
    List.fold_left
      (fun sum ((a, b), (c, d)) -> Rat.add sum (Rat.sub (Rat.mul a d) (Rat.mul b c)))
      Rat.zero (sides first corners)

let areas =
  QCheck2.Test.make ~count:30 ~name:"Regions: areas of features add up to that of the region"
    ~print:(fun c -> text (Polygon c)) polygon (fun c ->
        match Original.read (source (model (Polygon c))) with
        | Error _ -> true
        | Ok (m, _) ->
          let all = faces_only (features m) (pieces m) in
          let sum = List.fold_left (fun sum f -> Vec.add sum (area f)) Vec.zero all in
          Vec.equal sum (Vec.make Rat.zero Rat.zero (area_of c)))

(* {1 Bodies that are cut} *)

let tent = "shape Tent = polyhedron((-2,-2,0), (2,-2,0), (2,2,0), (-2,2,0), (-1,0,2), (1,0,2))\n"

let cut =
  read
    (tent ^ "region spot on Tent = polygon((-1/2,-1,1), (1/2,-1,1), (0,-3/2,1/2))\n\
             behaviour Open on Tent = <a, spot>. nil\nprocess p = Tent mass 3 [Open]")

let masses () =
  let parts = List.concat_map (fun (i : Ast.item) -> match i.it with Compound (_, ps, _, _) -> ps | _ -> [])
      cut in
  let share (a : Ast.attribute) =
    match a.it with Mass { it = Binary (Mul, share, _); _ } -> Some (number share) | _ -> None
  in
  let shares = List.concat_map (fun (p : Ast.part) -> List.filter_map share p.part_attributes) parts in
  Alcotest.(check bool) "several" true (List.length shares > 3);
  Alcotest.(check string) "they add up to the whole" "1" (Rat.to_string (List.fold_left Rat.add Rat.zero
                                                                           shares));
  let glues = List.concat_map (fun (i : Ast.item) -> match i.it with Compound (_, _, gs, _) -> gs | _ -> [])
      cut in
  Alcotest.(check int) "a tree" (List.length parts - 1) (List.length glues)

let slanted () =
  let fs = features cut and solids = solids "Tent" cut in
  let at x y z = has solids fs (Vec.make x y z) in
  Alcotest.(check bool) "in it" true (at Rat.zero (frac (-5) 4) (frac 3 4));
  Alcotest.(check bool) "a corner" true (at (frac 1 2) (q (-1)) Rat.one);
  Alcotest.(check bool) "beside it" false (at (frac 1 2) (frac (-5) 4) (frac 3 4));
  Alcotest.(check bool) "on the other side" false (at Rat.zero (frac 5 4) (frac 3 4))

(* Parts of faces, edges and corners, without a cut where none is needed. *)
let few_cuts () =
  let parts text =
    let m = read (Printf.sprintf
                    "shape Box = box(2, 2, 2)\nbehaviour Open on Box = <a, %s>. nil\nprocess p = Box mass 1 \
                     [Open]" text)
    in
    let count (i : Ast.item) = match i.it with Compound (_, ps, _, _) -> List.length ps | _ -> 0 in
    (List.fold_left (fun n i -> n + count i) 0 m, List.length (features m))
  in
  let check what expected text = Alcotest.(check (pair int int)) what expected (parts text) in
  check "an edge" (0, 1) "top ∩ left";
  check "all but two faces" (0, 5) "surface() ∖ interior(top) ∖ interior(left)";
  check "a corner" (0, 1) "point((1, 1, 1))";
  check "half a face" (2, 2) "top ∩ half((1, 0, 0), 0)";
  check "half an edge" (2, 2) "segment((-1, -1, 1), (0, -1, 1))";
  check "the whole face, by its corners" (0, 1) "polygon((-1, -1, 1), (-1, 1, 1), (1, 1, 1), (1, -1, 1))";
  check "a face without its edges" (0, 1) "surface() ∩ interior(top)"

let suite =
  ("regions",
   [
     ("points", Scc_test_support.Property.cases [ points; areas ]);
     ( "bodies",
       [
         Alcotest.test_case "Regions: masses of pieces" `Quick masses;
         Alcotest.test_case "Regions: on a slanted face" `Quick slanted;
         Alcotest.test_case "Regions: no more cuts than are needed" `Quick few_cuts;
       ] );
   ])
