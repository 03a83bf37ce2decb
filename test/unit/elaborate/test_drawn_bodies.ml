(* Compounds that a drawn solid is cut into (rule Decomposed). *)

open Scc_exact
open Scc_calculus
open Models
open Fault_case

(* An L, two high: a bar along x and one along y, with a reflex edge [d,j] between its faces inner and wall. *)
let ell_set =
  {|{
  vertices a (0,0,0)  b (6,0,0)  c (6,1,0)  d (1,1,0)  e (1,6,0)  f (0,6,0)
           g (0,0,2)  h (6,0,2)  i (6,1,2)  j (1,1,2)  k (1,6,2)  l (0,6,2)
  faces    bottom [a,f,e,d,c,b]  top [g,h,i,j,k,l]  front [a,b,h,g]  tip [b,c,i,h]
           inner [c,d,j,i]  wall [d,e,k,j]  end [e,f,l,k]  left [f,a,g,l]
}|}

let ell = "compound Ell = decompose " ^ ell_set ^ " mass 22\n"

(* A box with a pit, whose rim is drawn in four faces; it is no prism. *)
let pit =
  {|compound Pit = decompose {
  vertices a (0,0,0) b (4,0,0) c (4,4,0) d (0,4,0)  e (0,0,3) f (4,0,3) g (4,4,3) h (0,4,3)
           k (1,1,1) l (3,1,1) m (3,3,1) n (1,3,1)  k' (1,1,3) l' (3,1,3) m' (3,3,3) n' (1,3,3)
  faces    bottom [a,d,c,b] front [a,b,f,e] right [b,c,g,f] back [c,d,h,g] left [d,a,e,h]
           rim0 [e,f,l',k'] rim1 [f,g,m',l'] rim2 [g,h,n',m'] rim3 [h,e,k',n']
           floor [k,l,m,n] near [k,k',l',l] east [l,l',m',m] far [m,m',n',n] west [n,n',k',k]
} mass 40
|}

let leaf (t : Scc_elaborate.Elaborate.t) name =
  let leaves = t.model.leaves in
  match List.find_opt (fun (l : Model.leaf) -> String.equal l.name name) (Array.to_list leaves) with
  | Some l -> l
  | None -> Alcotest.fail name

let behaviour (t : Scc_elaborate.Elaborate.t) name =
  let all = List.concat_map (fun (p : State.process) ->
      Array.to_list p.leaves) (Array.to_list t.declared.processes) in
  let is (l : State.leaf) = String.equal t.model.leaves.(l.leaf).name name in
  match List.find_opt is all with
  | Some { behaviour = { term = Open (_, c, _); _ }; leaf; _ } -> (c, leaf)
  | _ -> Alcotest.fail name

let strings = Alcotest.(list string)

(* Which faces of the parts an active surface has, and how many edges and corners. *)
let surface t name =
  let c, leaf = behaviour t name in
  let faces, others = List.partition (fun (s : Site.t) ->
      Scc_geometry.Feature.dimension s.feature = 2) c.surface in
  (List.map (Model.site_name t.model ~leaf) faces, List.length others)

let opens what expected others features text =
  let t = accept (text ^ Printf.sprintf "process p = %s [<a, {%s}>. nil]" (String.sub text 9 3) features) in
  let faces, rest = surface t "p" in
  Alcotest.(check strings) what expected faces;
  Alcotest.(check int) (what ^ ": edges and corners") others rest

let channels () =
  (* one of two parts has the face; the other has its edge [d,j] with two corners as well *)
  opens "a face of one part" [ "p.p1.inner" ] (4 + 4 + 3) "inner" ell;
  opens "alone" [ "p.p1.inner" ] 0 "only inner" ell;
  (* in two pieces with five corners each that share an edge: of both the five edges and corners, and the seam
     twice *)
  opens "a face of two parts" [ "p.p1.top"; "p.p2.top" ] (8 + 8) "top" ell;
  opens "a seam is no edge" [ "p.p1.top"; "p.p2.top" ] 2 "only top" ell;
  opens "an edge of two parts, and its corners" [] 6 "[d, j]" ell;
  opens "a corner of two parts" [] 2 "j" ell;
  opens "by its own name" [ "p.p1.inner" ] (4 + 4 + 3) "p.inner" ell;
  opens "a piece, by its part" [ "p.p2.top" ] (4 + 4) "p2.top" ell;
  (* a part under the floor and four around it *)
  opens "names of one plane are one face" (List.init 4 (fun k ->
      Printf.sprintf "p.p%d.rim0" (k + 2))) 8 "only rim2" pit;
  opens "the face of a part that goes on under others" [ "p.p1.floor" ] 0 "only floor" pit

let masses () =
  let check what expected centre text =
    let t = accept text in
    let l = leaf t "p" in
    Alcotest.(check string) what (Rat.to_string expected) (Rat.to_string l.mass);
    Alcotest.(check string) (what ^ ": centre of mass") (Vec.to_string centre) (Vec.to_string
                                                                                  (Model.leaf_centroid l))
  in
  let half a = Rat.div (Rat.of_int a) (Rat.of_int 22) in
  (* 6 x 1 at (3, 1/2) and 1 x 5 at (1/2, 7/2), of area 11 *)
  let x = half 41 in
  check "an L" (Rat.of_int 22) (Vec.make x x Rat.one) (ell ^ "process p = Ell [nil]");
  check "scaled, moved" (Rat.of_int 5)
    (Vec.make (Rat.add x (Rat.of_int 10)) x (Rat.of_int 3))
    ("compound Ell = decompose " ^ ell_set ^
     " scaled (1, 1, 3) mass 5 at translate (10, 0, 0) process p = Ell [nil]");
  check "a family" (Rat.of_int 7)
    (Vec.make (Rat.mul x (Rat.of_int 2)) x Rat.one)
    ("compound Ell(k) = decompose " ^ ell_set ^
     " scaled (k, 1, 1) mass m where m = k + 5 process p = Ell(2) [nil]");
  let t = accept (ell ^ "param q in [0, 1] process p = Ell at translate (0, 0, q) [nil]") in
  Alcotest.(check int) "with a place that is not known" 2 (Array.length (leaf t "p").parts);
  let t = accept ("param q in [0, 1] compound Ell = decompose " ^ ell_set ^
                  " mass 1 at translate (0, 0, q) process p = Ell [nil]") in
  Alcotest.(check int) "or of its parts" 2 (Array.length (leaf t "p").parts)

let off =
  "OFF\n8 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n\
   3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n"

let meshes () =
  let read_file = function "box.off" -> Ok off | path -> Error ("no file " ^ path) in
  let t = accept ~read_file "compound Box = decompose \"box.off\" mass 1\n\
                             process p = Box [<a, {f2, f11, [v0, v1]}>. nil]" in
  Alcotest.(check int) "a convex mesh is one part, in triangles or not" 1 (Array.length (leaf t "p").parts);
  Alcotest.(check (pair strings int)) "triangles of one plane are one face" ([ "p.p1.f10";
                                                                               "p.p1.f2" ], 15) (surface t "p")

let bonds () =
  let text at face = ell ^ Printf.sprintf "process p = Ell [nil]\n\
                                           process q = box(1, 1, 1) mass 1 at translate %s [nil]\n\
                                           bond <a, {p.%s, q.bottom}>\n" at face in
  let ends text =
    let t = accept text in
    let b = List.concat_map (fun (p : State.process) ->
        Array.to_list p.bonds) (Array.to_list t.declared.processes) in
    List.map (fun (b : State.bond) -> Model.site_name t.model ~leaf:b.one.at b.one.site) b
  in
  Alcotest.(check strings) "on one piece" [ "p.p1.top" ] (ends (text "(5, 1/2, 5/2)" "top"));
  Alcotest.(check strings) "on the other" [ "p.p2.top" ] (ends (text "(1/2, 5, 5/2)" "top"));
  Alcotest.(check strings) "on both: the first of those that touch alike" [ "p.p1.top" ]
    (ends (text "(1/2, 1/2, 5/2)" "top"))

let faults =
  let body = "process p = Ell [nil]" in
  [
    case "a face that there is not" "SC0203" "innner" ~says:"inner" (ell ^ "process p = Ell [<a, {innner}>. nil]");
    case "an edge inside a face" "SC0203" "[a, i]" (ell ^ "process p = Ell [<a, {[a, i]}>. nil]");
    case "a part that there is not" "SC0203" "p9" ~says:"p1" (ell ^ "process p = Ell [<a, {p9.top}>. nil]");
    case "no mass" "SC0208" "Ell" ~says:"volumes" ("compound Ell = decompose " ^ ell_set ^ body);
    case "a mass of the body" "SC0212" "mass 3" (ell ^ "process p = Ell mass 3 [nil]");
    case "a mass that is known for no value" "SC0218" "m"
      ("param m in [1, 2] compound Ell = decompose " ^ ell_set ^ " mass m " ^ body);
    case "no file" "SC0101" "\"none.off\"" "compound Ell = decompose \"none.off\" mass 1 process p = Ell [nil]";
    case "a bond that nothing touches" "SC0401" "<a, {p.top, q.bottom}>"
      (ell ^ "process p = Ell [nil] process q = Ell at translate (20, 0, 0) [nil] bond <a, {p.top, q.bottom}>");
    case "a face that binding by contact cannot have" "SC0901" "floor"
      ("binding contact " ^ pit ^ "process p = Pit [<a, {floor}>. nil]");
    case "two names" "SC0202" "a"
      "compound T = decompose { vertices a (0,0,0) b (1,0,0) c (0,1,0) a (0,0,1) faces w [a,c,b] } mass 1";
    case "in a loop" "SC0210" "compound T = decompose \"t.off\" mass 1"
      "for i in 1..2 { compound T = decompose \"t.off\" mass 1 }";
  ]

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("drawn bodies",
   [
     ( "in order",
       [
         case "Decomposed: channels on drawn faces" channels;
         case "masses, places, families" masses;
         case "meshes" meshes;
         case "bonds" bonds;
       ] );
     ("faults", cases faults);
   ])
