(* Pictures worked out by hand. *)

open Scc_exact
open Scc_picture

(* In halves. *)
let box (x, x') (y, y') (z, z') : View.solid =
  let either i bit low high = if i land bit = 0 then low else high in
  let corner i = Ivec.of_ints (either i 1 x x') (either i 2 y y') (either i 4 z z') in
  {
    corners = Array.init 8 corner;
    denominator = Z.of_int 2;
    faces =
      [|
        [| 0; 2; 3; 1 |]; [| 4; 5; 7; 6 |]; [| 0; 1; 5; 4 |]; [| 2; 6; 7; 3 |]; [| 0; 4; 6; 2 |];
        [| 1; 3; 7; 5 |];
      |];
    edges =
      [| (0, 1); (0, 2); (0, 4); (1, 3); (1, 5); (2, 3); (2, 6); (3, 7); (4, 5); (4, 6); (5, 7); (6, 7) |];
  }

let see from solids =
  let camera = Camera.make (Vec.of_ints (fst from) (fst (snd from)) (snd (snd from))) in
  (camera, Hidden.make (View.make camera ~origin:Ivec.zero (Array.of_list solids)))

(* Who is seen where a point of space is, and on which face. *)
let body (camera, hidden) (x, y, z) =
  let p = Camera.turn camera (Ivec.of_ints x y z) in
  match Hidden.front hidden (Convex.point p.x p.y (Z.of_int 20)) with
  | None -> -1
  | Some i -> (Hidden.view hidden).faces.(i).body

let area hidden i =
  List.fold_left (fun sum p -> Rat.add sum (Convex.area2 p)) Rat.zero (Hidden.pieces hidden i)

let number = Alcotest.int

(* Each of three bars is behind the next one: no order of them paints them rightly. *)
let three_bars () =
  let bars = [ box (-12, 12) (2, 4) (-4, -2); box (-4, -2) (-12, 12) (2, 4); box (2, 4) (-4, -2) (-12, 12) ] in
  let picture = see (1, (1, 1)) bars in
  let crossing name expected p = Alcotest.check number name expected (body picture p) in
  crossing "the second before the first" 1 (-91, 29, -29);
  crossing "the third before the second" 2 (-29, -91, 29);
  crossing "the first before the third" 0 (29, -29, -91);
  crossing "the first alone" 0 (-1, 31, -31);
  crossing "nothing" (-1) (-119, 119, 0)

(* From above a stack is its uppermost floor, and faces that are edge-on are not there. *)
let stack () =
  let storeys = List.init 4 (fun i -> box (-2, 2) (-2, 2) (2 * i, (2 * i) + 2)) in
  let _, hidden = see (0, (0, 1)) storeys in
  let faces = (Hidden.view hidden).faces in
  Alcotest.check number "a face of each" 4 (Array.length faces);
  let seen i (f : View.face) =
    let expected = if f.body = 3 then 1 else 0 in
    Alcotest.check number "seen" expected (List.length (Hidden.pieces hidden i))
  in
  Array.iteri seen faces;
  let drawn = List.concat_map (Hidden.segments hidden) (Array.to_list (Hidden.view hidden).edges) in
  Alcotest.check number "four edges" 4 (List.length drawn)

(* A cube on a slab covers what is below it and what is behind it, and where they touch an edge is drawn. *)
let resting () =
  let slab = box (-8, 8) (-8, 8) (-2, 0) and cube = box (-2, 2) (-2, 2) (0, 4) in
  let _, alone = see (0, (-1, 1)) [ slab ] and _, both = see (0, (-1, 1)) [ slab; cube ] in
  let top hidden =
    let is (f : View.face) = f.body = 0 && Z.sign f.normal.z > 0 in
    let i = Option.get (List.find_opt (fun i -> is (Hidden.view hidden).faces.(i)) [ 0; 1; 2; 3 ]) in
    area hidden i
  in
  (* The cube, 2 wide and deep, stands on its square and hides one as large behind it. In the units of the picture
     the slab is 64 times 1, seen at half a right angle. *)
  let ratio = Rat.div (top both) (top alone) in
  Alcotest.(check string) "an eighth is hidden" "7/8" (Rat.to_string ratio);
  let foot (e : View.edge) = e.body = 1 && Option.is_some e.left <> Option.is_some e.right in
  let drawn = List.concat_map (Hidden.segments (snd (see (0, (-1, 1)) [ slab; cube ]))) in
  let outline = List.filter foot (Array.to_list (Hidden.view both).edges) in
  Alcotest.check number "its outline is all there" (List.length outline) (List.length (drawn outline))

(* A face that is no convex polygon is divided; its pieces cover it. *)
let letter_l () =
  let corner (x, z) = Vec.of_ints x 0 z in
  let l = Array.map corner [| (0, 0); (2, 0); (2, 1); (1, 1); (1, 2); (0, 2) |] in
  let drawn from faces =
    let soup = Soup.make (Camera.make from) ~origin:Ivec.zero l faces in
    let hidden = Hidden.make soup.view in
    let count = Array.length soup.view.faces in
    (Array.exists Soup.inner soup.view.faces, List.init count (area hidden))
  in
  let sum = List.fold_left Rat.add Rat.zero in
  let outside, areas = drawn (Vec.of_ints 0 (-1) 0) [| [| 0; 1; 2; 3; 4; 5 |] |] in
  Alcotest.(check bool) "from outside" false outside;
  Alcotest.(check string) "all of it" "6" (Rat.to_string (sum areas));
  let inside, areas = drawn (Vec.of_ints 0 1 0) [| [| 0; 1; 2; 3; 4; 5 |] |] in
  Alcotest.(check bool) "from inside" true inside;
  Alcotest.(check string) "all of it" "6" (Rat.to_string (sum areas));
  let wrong = [| [| 0; 1 |]; [| 0; 1; 9; -1; 2 |]; [| 3; 3; 3; 3 |] |] in
  let _, areas = drawn (Vec.of_ints 0 (-1) 0) wrong in
  Alcotest.(check string) "what is left of a face with wrong numbers" "2" (Rat.to_string (sum areas))

(* Six walls around a cube, in halves, and which of them are of glass from the right, above and the front. [at] is
   where the cube is along the first axis. The seventh solid is the cube, and an eighth one stands before it. *)
let glass ?(walls = fun _ -> true) ?(content = true) ?(more = []) at =
  let w = [ (-12, -10); (10, 12) ] and whole = (-12, 12) and inner = (-10, 10) in
  let each f = List.map f w in
  let room =
    each (fun z -> box whole whole z) @ each (fun y -> box whole y inner) @ each (fun x -> box x inner inner)
  in
  let cube = box (at, at + 4) (-10, -6) (-2, 2) in
  let solids = Array.of_list (List.filteri (fun i _ -> walls i) room @ (cube :: more)) in
  let camera = Camera.make (Vec.of_ints 11 10 20) in
  let hidden = Hidden.make (View.make camera ~origin:Ivec.zero solids) in
  let count = Array.length solids - 1 - List.length more in
  let body solids wall : Glass.body = { solids; wall; content = content && not wall } in
  let others = List.mapi (fun i _ -> body [ count + 1 + i ] true) more in
  let bodies = Array.of_list (body (List.init count Fun.id) true :: body [ count ] false :: others) in
  let found = Glass.find camera solids hidden bodies in
  List.filter found (List.init (Array.length solids) Fun.id)

let rooms () =
  let check = Alcotest.(check (list int)) in
  check "the near walls" [ 1; 3; 5 ] (glass (-2));
  check "the same, wherever the cube is" [ 1; 3; 5 ] (glass (-10));
  check "the same from the other end" [ 1; 3; 5 ] (glass 6);
  check "nothing inside" [] (glass ~content:false (-2));
  check "a floor hides nothing" [] (glass ~walls:(fun i -> i = 2) (-2));
  check "no wall before it" [] (glass ~walls:(fun i -> i <> 1 && i <> 3 && i <> 5) (-2));
  check "what stands beside it is opaque" [ 1; 3; 5 ] (glass ~more:[ box (4, 8) (-10, -6) (-2, 2) ] (-10));
  check "what stands before it is of glass" [ 1; 3; 5; 7 ] (glass ~more:[ box (-2, 6) (-10, -2) (4, 8) ] (-4))

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "picture"
    [
      ("hidden", [ case "three bars" three_bars; case "a stack" stack; case "resting" resting ]);
      ("glass", [ case "rooms" rooms ]);
      ("any faces", [ case "the letter L" letter_l ]);
    ]
