(* Extrusions of VRML and X3D: points against the specification in floats, solids by hand, and what is refused. *)
open Scc_base
open Scc_exact
open Scene_files
open Test_scenes
open Test_turn

let extruded fields = node "Shape" [ ("geometry", N [ node "Extrusion" fields ]) ]

(* {1 By hand} *)

let places =
  let small = ("crossSection", W "1 0 0 -1 -1 0 0 1 1 0") in
  [
    ("the default", [], "(-1, 0, -1) (1, 1, 1) solid");
    ("scaled", [ ("scale", W "2 3") ], "(-2, 0, -3) (2, 1, 3) solid");
    ("a frustum", [ ("scale", W "1 1 2 2") ], "(-2, 0, -2) (2, 1, 2) solid");
    ("a pyramid", [ ("scale", W "1 1 0 0") ], "(-1, 0, -1) (1, 1, 1) solid");
    ("clockwise", [ ("ccw", W "FALSE") ], "(-1, 0, -1) (1, 1, 1) no solid");
    ("without a cap", [ ("endCap", W "FALSE") ], "(-1, 0, -1) (1, 1, 1) no solid");
    ("an open curve", [ ("crossSection", W "1 1 1 -1 -1 -1 -1 1") ], "(-1, 0, -1) (1, 1, 1) no solid");
    ("along x", [ ("spine", W "0 0 0 2 0 0") ], "(0, -1, -1) (2, 1, 1) solid");
    ("along 3, 4, 0", [ small; ("spine", W "0 0 0 3 4 0") ], "(-4/5, -3/5, -1) (19/5, 23/5, 1) solid");
    ("a quarter turn", [ small; ("orientation", W "0 1 0 1.5707963") ], "(-1, 0, -1) (1, 1, 1) solid");
    ("leaning", [ ("orientation", W "1 0 0 0 1 0 0 0.3") ], "SC0323");
    ("twisted", [ ("orientation", W "0 1 0 0 0 1 0 0.3") ], "SC0323");
    ("more values than points", [ ("scale", W "1 1 1 1 5 5") ], "(-1, 0, -1) (1, 1, 1) solid");
  ]

let check_place (what, fields, expected) =
  let one (path, text) =
    let found = extent path text in
    let n = String.length found and m = String.length expected in
    let found = if expected = "SC0323" && n > m then String.sub found (n - m) m else found in
    Alcotest.(check string) text expected found
  in
  Alcotest.test_case what `Quick (fun () -> List.iter one (both [ extruded fields ]))

(* A closed spine: the caps would be a wall inside. *)
let ring () =
  let fields = [ ("crossSection", W "1 1 1 -1 -1 -1 -1 1 1 1"); ("spine", W "4 0 0 0 0 4 -4 0 0 0 0 -4 4 0 0") ] in
  let one (path, text) =
    match read path text with
    | Ok (set, _) ->
      Alcotest.(check (pair int int)) text (16, 16) (Array.length set.ifs_vertices, Array.length set.ifs_faces)
    | Error d -> Alcotest.fail d.message
  in
  List.iter one (both [ extruded fields ])

(* {1 The specification in floats} *)

let sub (a, b, c) (d, e, f) = (a -. d, b -. e, c -. f)
let add (a, b, c) (d, e, f) = (a +. d, b +. e, c +. f)
let times k (a, b, c) = (k *. a, k *. b, k *. c)
let dot (a, b, c) (d, e, f) = (a *. d) +. (b *. e) +. (c *. f)
let cross (a, b, c) (d, e, f) = ((b *. f) -. (c *. e), (c *. d) -. (a *. f), (a *. e) -. (b *. d))
let unit v = times (1. /. sqrt (dot v v)) v

(* X, Y and Z of each point of a spine that is bent at every point. *)
let bent spine =
  let n = Array.length spine in
  let closed = spine.(0) = spine.(n - 1) in
  let y i =
    if closed && (i = 0 || i = n - 1) then sub spine.(1) spine.(n - 2)
    else if i = 0 then sub spine.(1) spine.(0)
    else if i = n - 1 then sub spine.(n - 1) spine.(n - 2)
    else sub spine.(i + 1) spine.(i - 1)
  in
  let z i =
    if closed && (i = 0 || i = n - 1) then cross (sub spine.(1) spine.(0)) (sub spine.(n - 2) spine.(0))
    else
      let i = max 1 (min (n - 2) i) in
      cross (sub spine.(i + 1) spine.(i)) (sub spine.(i - 1) spine.(i))
  in
  let before = ref (z 0) in
  let frame i =
    let own = z i in
    let own = if dot own !before < 0. then times (-1.) own else own in
    before := own;
    let y = unit (y i) and z = unit own in
    (cross y z, y, z)
  in
  let frames = Array.init n frame in
  if closed then frames.(n - 1) <- frames.(0);
  frames

(* One that is straight: (0, 1, 0) turned to it, about an axis that is at right angles to both. *)
let straight spine =
  let d = unit (sub spine.(1) spine.(0)) in
  let axis = cross (0., 1., 0.) d in
  let angle = acos (dot (0., 1., 0.) d) in
  let turned v = if dot axis axis = 0. then v else rotated axis angle v in
  Array.map (fun _ -> (turned (1., 0., 0.), turned (0., 1., 0.), turned (0., 0., 1.))) spine

let placed (x, y, z) at (sx, sz) (axis, angle) (cx, cz) =
  let flat = (sx *. cx, 0., sz *. cz) in
  let a, b, c = if angle = 0. then flat else rotated axis angle flat in
  add at (add (times a x) (add (times b y) (times c z)))

let curve = [ (1., 0.); (0.5, -0.75); (-1., -0.25); (-0.5, 0.75) ]

(* How far a place is from the nearest point: equal points of a closed spine are one. *)
let far_off frames spine scales turns points =
  let f = Rat.to_float in
  let floats = Array.map (fun (v : Vec.t) -> (f v.x, f v.y, f v.z)) points in
  let square place v = let d = sub place v in dot d d in
  let near place = Array.fold_left (fun least v -> Float.min least (square place v)) infinity floats in
  let one i = List.map (fun c -> near (placed frames.(i) spine.(i) scales.(i) turns.(i) c)) curve in
  sqrt (List.fold_left Float.max 0. (List.concat (List.init (Array.length spine) one)))

let text_of spine scales turns =
  let number = Printf.sprintf "%g" in
  let triple (a, b, c) = [ a; b; c ] in
  let words l = W (String.concat " " (List.map number l)) in
  let all f a = words (List.concat_map f (Array.to_list a)) in
  extruded
    [
      ("crossSection", words (List.concat_map (fun (x, z) -> [ x; z ]) (curve @ [ List.hd curve ])));
      ("spine", all triple spine); ("scale", all (fun (x, z) -> [ x; z ]) scales);
      ("orientation", all (fun (axis, angle) -> triple axis @ [ angle ]) turns);
    ]

let agree frames spine scales turns =
  let path, text = List.hd (both [ text_of spine scales turns ]) in
  match read path text with
  | Error d -> d.Diag.code = "SC0321"  (* three random points in line, or a spine downwards *)
  | Ok (set, _) -> far_off (frames spine) spine scales turns (Array.map snd set.ifs_vertices) < 1e-6

let spines =
  let open QCheck2 in
  let eighths = Gen.map (fun n -> float n /. 8.) (Gen.int_range (-40) 40) in
  let point = Gen.triple eighths eighths eighths in
  let scale = Gen.map (fun n -> float n /. 4.) (Gen.int_range 1 8) in
  let turn = Gen.pair (Gen.triple eighths eighths (Gen.return 1.)) (Gen.oneof [ Gen.return 0.; eighths ]) in
  let in_line a b c = let v = cross (sub b a) (sub c b) in dot v v = 0. in
  let all_bent s =
    let n = Array.length s in
    let inner = List.init (n - 2) (fun i -> in_line s.(i) s.(i + 1) s.(i + 2)) in
    not (List.mem true (in_line s.(n - 2) s.(0) s.(1) :: inner))
  in
  let of_each n gen = Gen.array_size (Gen.return n) gen in
  let values n = Gen.pair (of_each n (Gen.pair scale scale)) (of_each n turn) in
  let with_values spine = Gen.map (fun v -> (spine, v)) (values (Array.length spine)) in
  let open_spine = Gen.array_size (Gen.int_range 3 6) point in
  let closed = Gen.map (fun s -> Array.append s [| s.(0) |]) (Gen.array_size (Gen.int_range 3 5) point) in
  let along (a, d) = Array.init 3 (fun i -> add a (times (float (i * i)) d)) in
  let line = Gen.map along (Gen.pair point point) in
  [
    Test.make ~name:"bent spines stand where the specification in floats has them" ~count:500
      (Gen.bind (Gen.oneof [ open_spine; closed ]) with_values)
      (fun (spine, (scales, turns)) -> (not (all_bent spine)) || agree bent spine scales turns);
    Test.make ~name:"and so do straight ones" ~count:300 (Gen.bind line with_values)
      (fun (spine, (scales, turns)) -> agree straight spine scales turns);
  ]

(* {1 What is refused} *)

let refusals =
  let many n word = W (String.concat " " (List.init n (fun i -> Printf.sprintf word i))) in
  [
    ("downwards", [ ("spine", W "0 1 0 0 0 0") ], "SC0321");
    ("back", [ ("spine", W "0 0 0 0 2 0 0 1 0") ], "SC0321");
    ("back at a bend", [ ("spine", W "0 0 0 1 1 0 0 0 0 0 0 1") ], "SC0321");
    ("equal points", [ ("spine", W "0 0 0 0 0 0 0 1 0") ], "SC0321");
    ("one point", [ ("spine", W "0 0 0") ], "SC0320");
    ("no point", [ ("spine", W "") ], "SC0320"); ("a half point", [ ("spine", W "0 0 0 1") ], "SC0320");
    ("too few scales", [ ("spine", W "0 0 0 0 1 0 0 2 0"); ("scale", W "1 1 2 2") ], "SC0320");
    ("a negative scale", [ ("scale", W "1 -1") ], "SC0320");
    ("no axis", [ ("orientation", W "0 0 0 1") ], "SC0320");
    ("a bomb", [ ("spine", many 30_000 "0 %d 0"); ("crossSection", many 30_000 "0 %d") ], "SC0320");
  ]

let check_refusal (what, fields, code) =
  let one (path, text) =
    match read path text with
    | Error d -> Alcotest.(check string) what code d.Diag.code
    | Ok _ -> Alcotest.fail (what ^ " is read")
  in
  Alcotest.test_case what `Quick (fun () -> List.iter one (both [ extruded fields ]))

let suite =
  ( "extrusions",
    [
      ("places", Alcotest.test_case "a ring" `Quick ring :: List.map check_place places);
      ("frames", List.map Scc_test_support.Property.case spines);
      ("refusals", List.map check_refusal refusals);
    ] )
