open Scc_exact
open Scc_geometry
open Scc_rigid
open Bodies

let check_vec what a b = Alcotest.(check string) what (Vec.to_string a) (Vec.to_string b)

(* {1 Random collisions}

   Any corners and normals will do: the laws do not ask where a contact comes from. Bodies of one or two parts. *)

let small = Gen.map (fun (x, y, z) -> Solids.halves (x, y, z)) Gen.(triple (-4 -- 4) (-4 -- 4) (-4 -- 4))

let mass =
  let part = Gen.map2 (fun body m -> { Mass.body; mass = Rat.of_int m }) (placed square_turn small) Gen.(1 -- 4) in
  Gen.map Mass.of_parts (Gen.list_size Gen.(1 -- 2) part)

let mover fixed_too =
  let moving = Gen.map3 (fun mass velocity spin -> { Impact.mass = Some mass; velocity; spin }) mass small small in
  let fixed = Gen.return { Impact.mass = None; velocity = Vec.zero; spin = Vec.zero } in
  if fixed_too then Gen.frequency [ (4, moving); (1, fixed) ] else moving

let no_pair : Contact.pair = { first = Vertex 0; second = Vertex 0; dimension = 0 }

(* Only the corners and the normal count here. *)
let contact_of normal corners : Near_contact.t =
  let nothing = { Placed.solid = named "cube"; turned = Quaternion.identity; at = Vec.zero } in
  {
    first = nothing;
    second = nothing;
    gap = Ivec.to_vec normal;
    normals = [ normal ];
    corners;
    pairs = [ no_pair ];
    highest = no_pair;
    plane = (normal, Rat.zero);
  }

let contact =
  let normal =
    Gen.map
      (function 0, 0, 0 -> Ivec.of_ints 1 0 0 | x, y, z -> Ivec.primitive (Ivec.of_ints x y z))
      Gen.(triple (-3 -- 3) (-3 -- 3) (-3 -- 3))
  in
  Gen.map2 contact_of normal (Gen.list_size Gen.(1 -- 4) small)

type scene = { a : Impact.mover; b : Impact.mover; contacts : Near_contact.t list }

let scene_of mover =
  Gen.map2 (fun (a, b) contacts -> { a; b; contacts }) (Gen.pair mover mover) (Gen.list_size Gen.(1 -- 2) contact)

let scene = scene_of (mover false)
let also_fixed = scene_of (mover true)

let show_mover (m : Impact.mover) =
  Printf.sprintf "%s v %s spin %s"
    (match m.mass with
     | None -> "fixed"
     | Some b -> Printf.sprintf "mass %s at %s" (Rat.to_string b.mass) (Vec.to_string b.centre))
    (Vec.to_string m.velocity) (Vec.to_string m.spin)

let show_contact (c : Near_contact.t) =
  Printf.sprintf "normals %s corners %s"
    (String.concat " " (List.map Ivec.to_string c.normals))
    (String.concat " " (List.map Vec.to_string c.corners))

let print s = String.concat "; " (show_mover s.a :: show_mover s.b :: List.map show_contact s.contacts)
let property ?(gen = scene) name ~count f = QCheck2.Test.make ~name ~count ~print gen f

let rows (c : Near_contact.t) =
  List.concat_map
    (fun normal -> List.map (fun corner -> { Impact.first = 0; second = 1; normal; corner }) c.corners)
    c.normals

(* As if no part covered another. *)
let respond a b contacts =
  match Impact.reflect [| a; b |] (List.concat_map rows (List.filter (Impact.approaching a b) contacts)) with
  | Some after -> Impact.Bounced (after.(0), after.(1))
  | None -> Persistent

(* {1 What is kept} *)

let zero_if_fixed f (m : Impact.mover) = match m.mass with None -> Vec.zero | Some b -> f b m
let momentum = zero_if_fixed (fun b m -> Mass.momentum b ~velocity:m.velocity)

let turning about =
  zero_if_fixed (fun b m -> Mass.angular_momentum b ~velocity:m.velocity ~spin:m.spin ~about)

let energy (m : Impact.mover) =
  match m.mass with None -> Rat.zero | Some b -> Mass.energy b ~velocity:m.velocity ~spin:m.spin

let sum f a b = Vec.add (f a) (f b)
let energies a b = Rat.add (energy a) (energy b)

let bounced f s = match respond s.a s.b s.contacts with Persistent -> true | Bounced (a, b) -> f s a b

let keeps s a b =
  Vec.equal (sum momentum s.a s.b) (sum momentum a b)
  && Vec.equal (sum (turning Vec.zero) s.a s.b) (sum (turning Vec.zero) a b)
  && Vec.equal (sum (turning (v 5 (-3) 2)) s.a s.b) (sum (turning (v 5 (-3) 2)) a b)
  && Rat.equal (energies s.a s.b) (energies a b)

let is_fixed (m : Impact.mover) = Option.is_none m.mass
let unmoved (m : Impact.mover) = Vec.is_zero m.velocity && Vec.is_zero m.spin

let with_fixed s a b =
  Rat.equal (energies s.a s.b) (energies a b)
  && ((not (is_fixed s.a)) || unmoved a)
  && ((not (is_fixed s.b)) || unmoved b)

(* {1 Where it leads} *)

let speed a b n x = Vec.dot (Ivec.to_vec n) (Vec.sub (Impact.velocity_at b x) (Impact.velocity_at a x))
(* What approached leaves at least as fast. *)
let reflected s a b =
  List.filter (Impact.approaching s.a s.b) s.contacts
  |> List.concat_map rows
  |> List.for_all (fun { Impact.normal = n; corner = x; _ } ->
      Rat.compare (speed a b n x) (Rat.neg (speed s.a s.b n x)) >= 0)

let answered s =
  let approach = List.exists (Impact.approaching s.a s.b) s.contacts in
  match respond s.a s.b s.contacts with
  | Persistent -> (not approach) || (is_fixed s.a && is_fixed s.b)
  | Bounced _ -> approach

(* Whether one body is in front of the other, as far as the normals tell: a peg in a hole may knock for ever. *)
let apart_one_way s =
  let normals = List.concat_map (fun (c : Near_contact.t) -> c.normals) s.contacts in
  let agree n m = Z.sign (Ivec.dot n m) > 0 in
  List.for_all (fun n -> List.for_all (agree n) normals) normals

(* A corner that did not approach may do so after; then the two collide again, and that ends. *)
let ends s =
  (not (apart_one_way s))
  ||
  let rec go n a b =
    match respond a b s.contacts with Persistent -> true | Bounced (a, b) -> n > 0 && go (n - 1) a b
  in
  go 40 s.a s.b

(* {1 Symmetry} *)

let same_mover (a : Impact.mover) (b : Impact.mover) = Vec.equal a.velocity b.velocity && Vec.equal a.spin b.spin

let same_response x y =
  match (x, y) with
  | Impact.Persistent, Impact.Persistent -> true
  | Bounced (a, b), Bounced (c, d) -> same_mover a c && same_mover b d
  | Bounced _, Persistent | Persistent, Bounced _ -> false

(* In the plane x = 0. Spins are axial: they keep the part along x and turn the others. *)
let mirror (p : Vec.t) = { p with x = Rat.neg p.x }
let mirror_normal (n : Ivec.t) = { n with x = Z.neg n.x }
let mirror_spin p = Vec.neg (mirror p)

let mirror_mass (b : Mass.t) =
  let m = Mat.diagonal (v (-1) 1 1) in
  { b with centre = mirror b.centre; inertia = Mat.mul m (Mat.mul b.inertia m) }

let mirror_mover (a : Impact.mover) =
  {
    Impact.mass = Option.map mirror_mass a.mass;
    velocity = mirror a.velocity;
    spin = mirror_spin a.spin;
  }

let mirror_contact (c : Near_contact.t) =
  {
    c with
    gap = mirror c.gap;
    normals = List.map mirror_normal c.normals;
    corners = List.map mirror c.corners;
  }

let mirror_response = function
  | Impact.Persistent -> Impact.Persistent
  | Bounced (a, b) -> Bounced (mirror_mover a, mirror_mover b)

let mirrored s =
  same_response
    (mirror_response (respond s.a s.b s.contacts))
    (respond (mirror_mover s.a) (mirror_mover s.b) (List.map mirror_contact s.contacts))

let turn_round (c : Near_contact.t) =
  { c with gap = Vec.neg c.gap; normals = List.map Ivec.neg c.normals }

let exchanged s =
  let back = respond s.b s.a (List.map turn_round s.contacts) in
  let back = match back with Bounced (b, a) -> Impact.Bounced (a, b) | Persistent -> Persistent in
  same_response (respond s.a s.b s.contacts) back

(* {1 Real contacts} *)

let resolution = ratio 1 1048576

let real =
  let scene pair ((va, sa), (vb, sb), lift) =
    match pair with
    | None -> None
    | Some ((a : Placed.t), (b : Placed.t)) ->
      let o = Obstacle.make (Placed.fixed_solid a) (Placed.fixed_solid b) in
      let n = List.fold_left Ivec.add Ivec.zero (Obstacle.separating o (Vec.sub b.at a.at)) in
      let b = if lift then { b with at = Vec.axpy (ratio 1 1000000000) (Ivec.to_vec n) b.at } else b in
      let mover body velocity spin =
        let mass = Rat.of_int (1 + body.Placed.solid.id) in
        { Impact.mass = Some (Mass.of_part { body; mass }); velocity; spin }
      in
      Option.map
        (fun c -> { a = mover a va sa; b = mover b vb sb; contacts = [ c ] })
        (Near_contact.find ~resolution a b)
  in
  let motion = Gen.pair small small in
  Gen.map2 scene touching_pair (Gen.triple motion motion Gen.bool)

let bounced_really f s =
  match Impact.bounce s.a s.b s.contacts with Persistent -> true | Bounced (a, b) -> f s a b

let of_real name ~count f =
  let print = function Some s -> print s | None -> "none" in
  QCheck2.Test.make ~name ~count ~print real (function None -> true | Some s -> f s)

(* Without spins and turning moments it is the response in translation, shared by the masses. *)
let place name at = { Placed.solid = named name; turned = Quaternion.identity; at }

let as_in_translation what a b w =
  let mass body m = Some (Mass.of_part { Mass.body; mass = Rat.of_int m }) in
  let one = { Impact.mass = mass a 1; velocity = Vec.zero; spin = Vec.zero } in
  let two = { Impact.mass = mass b 3; velocity = w; spin = Vec.zero } in
  let o = Obstacle.make a.Placed.solid b.Placed.solid and offset = Vec.sub b.at a.at in
  let after = Response.bounce [ { obstacle = o; offset } ] w in
  let impulse = Vec.sub after w in
  match Impact.bounce one two (Option.to_list (Near_contact.find ~resolution a b)) with
  | Persistent -> Alcotest.failf "%s: no response" what
  | Bounced (x, y) ->
    check_vec (what ^ ", first") (Vec.scale (ratio (-3) 4) impulse) x.velocity;
    check_vec (what ^ ", second") (Vec.axpy (ratio 1 4) impulse w) y.velocity;
    check_vec (what ^ ", first spin") Vec.zero x.spin;
    check_vec (what ^ ", second spin") Vec.zero y.spin

let central () =
  as_in_translation "face to face" (place "slab" Vec.zero) (place "cube" (v 0 0 2)) (v 1 2 (-3));
  as_in_translation "vertex to vertex" (place "cube" Vec.zero) (place "cube" (v 2 2 2)) (v (-1) (-1) (-1));
  as_in_translation "tip on face" (place "cube" Vec.zero) (place "octahedron" (v 0 0 2)) (v 0 1 (-1));
  let gap = Vec.make Rat.zero Rat.zero (Rat.add (Rat.of_int 2) (ratio 1 4194304)) in
  match Near_contact.find ~resolution (place "slab" Vec.zero) (place "cube" gap) with
  | None -> Alcotest.fail "a gap"
  | Some c ->
    let mass body = Some (Mass.of_part { Mass.body; mass = Rat.one }) in
    let still = { Impact.mass = mass (place "slab" Vec.zero); velocity = Vec.zero; spin = Vec.zero } in
    let falling = { still with mass = mass (place "cube" gap); velocity = v 1 2 (-3) } in
    (match Impact.bounce still falling [ c ] with
     | Bounced (x, y) ->
       check_vec "over a gap, first" (v 0 0 (-3)) x.velocity;
       check_vec "over a gap, second" (v 1 2 0) y.velocity
     | Persistent -> Alcotest.fail "over a gap")

(* A tip on the seam of two flush cubes. *)
let flush_tiles () =
  let cube_at at = place "cube" at in
  let falling at velocity =
    { Impact.mass = Some (Mass.of_part { body = at; mass = Rat.one }); velocity; spin = Vec.zero }
  in
  let ground = { Impact.mass = None; velocity = Vec.zero; spin = Vec.zero } in
  let top = place "octahedron" (v 0 0 2) in
  let contacts parts = List.filter_map (fun p -> Near_contact.find ~resolution p top) parts in
  let two = contacts [ cube_at (v 1 0 0); cube_at (v (-1) 0 0) ] in
  Alcotest.(check int) "the tip touches both" 2 (List.length two);
  let velocity = v 1 0 (-2) in
  match Impact.bounce ground (falling top velocity) two with
  | Bounced (_, b) -> check_vec "straight up" (v 1 0 2) b.velocity
  | Persistent -> Alcotest.fail "tiles"

(* The same, hardly above the floor, and hardly beside the seam: the nearest point of the second cube is its edge,
   but that is an inner corner. Beside the edge of a single cube it is not. *)
let beside_the_seam () =
  let d = ratio 1 4194304 in
  let top = place "octahedron" (Vec.make (Rat.neg d) Rat.zero (Rat.add (Rat.of_int 2) (Rat.add d d))) in
  let mass = Some (Mass.of_part { Mass.body = top; mass = Rat.one }) in
  let falling = { Impact.mass; velocity = v 1 0 (-2); spin = Vec.zero } in
  let ground = { Impact.mass = None; velocity = Vec.zero; spin = Vec.zero } in
  let near parts = List.filter_map (fun at -> Near_contact.find ~resolution (place "cube" at) top) parts in
  let bounce what parts expected =
    match Impact.bounce ground falling (near parts) with
    | Persistent -> Alcotest.fail what
    | Bounced (_, b) -> check_vec what expected b.velocity
  in
  bounce "two cubes" [ v 1 0 0; v (-1) 0 0 ] (v 1 0 2);
  bounce "in the other order" [ v (-1) 0 0; v 1 0 0 ] (v 1 0 2);
  bounce "one cube" [ v (-1) 0 0 ] (v 1 0 2);
  (* n = (-1, 0, 2) with n.w = -5; the tip is 1 below the centre, so that the turning moment is 1 about y, and the
     inertia is 1/5: the impulse is 2 * 5 / (5 + 5) n *)
  bounce "an edge" [ v 1 0 0 ] (v 0 0 0)

(* Where no corner is an inner one, each contact has the normal of its gap: beside an edge, and against a wall. *)
let edge_and_wall () =
  let d = ratio 1 4194304 in
  let at = Vec.make (Rat.neg d) Rat.zero (Rat.add (Rat.of_int 2) (Rat.add d d)) in
  let top = place "octahedron" at in
  let mass = Some (Mass.of_part { Mass.body = top; mass = Rat.one }) in
  let falling = { Impact.mass; velocity = v 1 1 (-2); spin = Vec.zero } in
  let ground = { Impact.mass = None; velocity = Vec.zero; spin = Vec.zero } in
  let parts = [ place "cube" (v 1 0 0); place "cube" { at with y = Rat.of_int 2 } ] in
  let contacts = List.filter_map (fun p -> Near_contact.find ~resolution p top) parts in
  Alcotest.(check (list string)) "normals" [ "(-1, 0, 2)"; "(0, -1, 0)" ]
    (List.concat_map (fun (c : Near_contact.t) -> List.map Ivec.to_string c.normals) contacts);
  Alcotest.(check bool) "both count" true
    (same_response (Impact.bounce ground falling contacts) (respond ground falling contacts))

(* Two cubes that meet edge to edge and spin, each the image of the other. *)
let head_on () =
  let a = place "cube" (v (-1) (-1) 0) and b = place "cube" (v 1 1 0) in
  let mover body velocity spin =
    { Impact.mass = Some (Mass.of_part { Mass.body; mass = Rat.one }); velocity; spin }
  in
  let contacts = Option.to_list (Near_contact.find ~resolution a b) in
  match Impact.bounce (mover a (v 2 0 0) (v 0 0 1)) (mover b (v (-2) 0 0) (v 0 0 1)) contacts with
  | Persistent -> Alcotest.fail "head on"
  | Bounced (x, y) ->
    (* half a turn about z takes one to the other *)
    check_vec "velocities" (Vec.make (Rat.neg x.velocity.x) (Rat.neg x.velocity.y) x.velocity.z) y.velocity;
    check_vec "spins" x.spin y.spin

(* A plank (8 x 2 x 1 half sides) that hits a post with its end: m = 1, I about y is (64 + 1)/3. *)
let off_centre () =
  let plank = place "plank" Vec.zero in
  let m = Mass.of_part { body = plank; mass = Rat.one } in
  let falling = { Impact.mass = Some m; velocity = v 0 0 (-1); spin = Vec.zero } in
  let post = { Impact.mass = None; velocity = Vec.zero; spin = Vec.zero } in
  let c = contact_of (Ivec.of_ints 0 0 1) [ v 8 0 (-1) ] in
  match Impact.bounce post falling [ c ] with
  | Persistent -> Alcotest.fail "off centre"
  | Bounced (_, b) ->
    (* 1/m + 8^2/I = 1 + 192/65 = 257/65, so the impulse is 2 * 65/257 = 130/257 *)
    check_vec "velocity" (Vec.make Rat.zero Rat.zero (ratio (-127) 257)) b.velocity;
    check_vec "spin" (Vec.make Rat.zero (ratio (-48) 257) Rat.zero) b.spin

(* {1 Bind and split} *)

let bound s =
  let whole = Impact.bind [ s.a; s.b ] in
  if is_fixed s.a || is_fixed s.b then is_fixed whole && unmoved whole
  else
    Vec.equal (momentum whole) (sum momentum s.a s.b)
    && Vec.equal (turning (v 1 2 3) whole) (sum (turning (v 1 2 3)) s.a s.b)
    && Rat.compare (energy whole) (energies s.a s.b) <= 0

(* Pieces go on as they moved, and together they keep all that the whole has; bound again, they are the whole. *)
let split s =
  let whole = Impact.bind [ s.a; s.b ] in
  let a = Impact.piece whole s.a.mass and b = Impact.piece whole s.b.mass in
  same_mover (Impact.bind [ a; b ]) whole
  && (is_fixed whole || Rat.equal (energies a b) (energy whole))
  && List.for_all (fun x -> Vec.equal (Impact.velocity_at whole x) (Impact.velocity_at a x) || is_fixed s.a)
    [ v 1 2 3; v 0 (-4) 1 ]

let suite =
  ("impact",
   [ ( "known",
       [ Alcotest.test_case "central hits" `Quick central; Alcotest.test_case "off centre" `Quick off_centre;
         Alcotest.test_case "two flush tiles (reading I-13)" `Quick flush_tiles;
         Alcotest.test_case "beside a seam" `Quick beside_the_seam;
         Alcotest.test_case "beside an edge, and a wall" `Quick edge_and_wall;
         Alcotest.test_case "symmetric spins" `Quick head_on ] );
     ( "properties",
       Scc_test_support.Property.cases
         [ property "momentum, angular momentum and energy are kept" ~count:600 (bounced keeps);
           property "a fixed body takes nothing" ~count:100 ~gen:also_fixed (bounced with_fixed);
           property "what approached leaves" ~count:200 ~gen:also_fixed (bounced reflected);
           property "there is a response iff a contact approaches" ~count:100 ~gen:also_fixed answered;
           property "repeated collisions end" ~count:120 ends;
           property "mirrored" ~count:100 ~gen:also_fixed mirrored;
           property "exchanged" ~count:100 ~gen:also_fixed exchanged;
           of_real "real contacts: kept" ~count:40 (bounced_really keeps);
           of_real "real contacts: what approached leaves" ~count:40 (bounced_really reflected);
           property "bind" ~count:100 ~gen:also_fixed bound;
           property "split" ~count:100 ~gen:also_fixed split ] ) ])
