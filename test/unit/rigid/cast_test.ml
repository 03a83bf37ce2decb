(* Casts of turning solids against the exact sweep. *)

open Scc_exact
open Scc_geometry
open Scc_rigid
module Gen = QCheck2.Gen

let ratio = Bodies.ratio

(* {1 The reference} *)

(* floor(t 2^grid), from a float and corrected exactly. *)
let cell grid t =
  let power = Z.shift_left Z.one grid in
  let below k = Algebraic.compare_rat t (Rat.make k power) < 0 in
  let rec settle k = if below k then settle (Z.pred k) else if below (Z.succ k) then k else settle (Z.succ k) in
  let low, _ = Algebraic.enclose t ~width:(Rat.make Z.one power) in
  Rat.make (settle (Rat.floor (Rat.mul low (Q.of_bigint power)))) power

let reference ?(phase = Rat.zero) a b ~span ~grid : Cast.outcome =
  match Sweep.relation a b Rat.zero with
  | Interpenetrating -> Inside
  | Apart | Touching -> (
      match Sweep.first_penetration a b ~from:Rat.zero ~until:span with
      | Never -> Never
      | At t -> At (Rat.max Rat.zero (Rat.sub (cell grid (Algebraic.add_rat phase t)) phase)))

let show : Cast.outcome -> string = function
  | Never -> "never"
  | Inside -> "inside"
  | At t -> "at " ^ Rat.to_string t

let equal (x : Cast.outcome) (y : Cast.outcome) =
  match (x, y) with
  | Never, Never | Inside, Inside -> true
  | At t, At u -> Rat.equal t u
  | (Never | Inside | At _), _ -> false

(* {1 Motions} *)

type case = { a : Motion.t; b : Motion.t; span : Rat.t; grid : int }

let print c =
  let motion name (m : Motion.t) =
    Printf.sprintf "%s: solid %d, turned %s, arm %s, centre %s, velocity %s, spin %s, since %s" name m.solid.id
      (Quaternion.to_string m.turned) (Vec.to_string m.arm) (Vec.to_string m.centre) (Vec.to_string m.velocity)
      (Vec.to_string m.spin) (Rat.to_string m.since)
  in
  String.concat "\n"
    [ motion "A" c.a; motion "B" c.b; Printf.sprintf "span %s, grid %d" (Rat.to_string c.span) c.grid;
      "cast: " ^ show (Cast.first_time_of_contact c.a c.b ~span:c.span ~grid:c.grid);
      "sweep: " ^ show (reference c.a c.b ~span:c.span ~grid:c.grid) ]

let agrees c =
  let grid = c.grid and span = c.span in
  let expected = reference c.a c.b ~span ~grid in
  equal (Cast.first_time_of_contact c.a c.b ~span ~grid) expected
  && equal (Cast.first_time_of_contact c.b c.a ~span ~grid) expected

(* The grid counts from an instant before the start. *)
let agrees_later (c, phase) =
  let grid = c.grid and span = c.span in
  let expected = reference c.a c.b ~phase ~span ~grid in
  equal (Cast.first_time_of_contact c.a c.b ~phase ~span ~grid) expected
  && equal (Cast.first_time_of_contact c.b c.a ~phase ~span ~grid) expected
  &&
  let next = Cast.next_instant ~grid ~phase span in
  let cells = Rat.mul (Rat.add next phase) (Rat.make (Z.shift_left Z.one grid) Z.one) in
  Z.equal cells.den Z.one && Rat.compare next span > 0
  && Rat.compare (Rat.sub next (Rat.make Z.one (Z.shift_left Z.one grid))) span <= 0

let quotient top bottom = Gen.map (fun k -> ratio k bottom) Gen.(-top -- top)
let vector top bottom = Gen.map3 Vec.make (quotient top bottom) (quotient top bottom) (quotient top bottom)
let zero = Gen.return Vec.zero

(* The span is at most 1, so that half of |spin| span is at most a quarter. *)
let spin = Gen.oneof [ zero; vector 288 1000; vector 2 7; vector 9 997 ]
let scaled k (s : Solid.t) id = Solid.make ~id s.polyhedron (Mat.mul (Mat.scale k Mat.identity) s.linear)
let hull = lazy (Scc_test_data.Test_data.(solid ~id:90 (shape "../../data/geometry/poly50.txt") Mat.identity))
let small_hull = lazy (scaled (ratio 1 500) (Lazy.force hull) 91)
let simple = Gen.oneofl [ "cube"; "tetrahedron" ] |> Gen.map Bodies.named
let any_solid = Gen.frequency [ (3, simple); (2, Bodies.solid) ]
let hulls = Gen.map (fun () -> Lazy.force small_hull) Gen.unit
let grid = Gen.oneofl [ 0; 3; 10; 25; 40 ]
let span = Gen.oneofl [ Rat.one; ratio 1 3; ratio 7 8; ratio 1 1000 ]
let since = Gen.oneof [ Gen.return Rat.zero; Gen.map (fun k -> ratio k 100) Gen.(0 -- 90) ]

let motion ?(spin = spin) solid centre velocity =
  let make (solid, turned, (about_centroid, arm)) (centre, velocity) (spin, since) : Motion.t =
    let arm = if about_centroid then Vec.neg (Quaternion.apply turned solid.Solid.centroid) else arm in
    { solid; turned; arm; centre; velocity; spin; since }
  in
  Gen.map3 make
    Gen.(triple solid Bodies.turn (pair bool (vector 3 2)))
    (Gen.pair centre velocity) (Gen.pair spin since)

(* B comes from a few lengths away, at a speed that takes it past A in a step. *)
let flying solid =
  let go a (direction, aside, (k, speed)) span grid =
    Gen.map
      (fun (b : Motion.t) ->
         let centre = Vec.axpy k direction aside in
         { a; b = { b with centre; velocity = Vec.scale (Rat.neg speed) direction }; span; grid })
      (motion solid zero zero)
  in
  Gen.bind (motion solid zero zero) (fun a ->
      Gen.bind
        (Gen.triple (vector 10 3) (vector 15 10) (Gen.pair (quotient 4 2) (quotient 9 3)))
        (fun way -> Gen.bind (Gen.pair span grid) (fun (span, grid) -> go a way span grid)))

(* {1 At the edge} *)

let power_of_two k = Rat.make Z.one (Z.shift_left Z.one k)

(* A point of A's surface at an instant: in a face, on an edge or a vertex. *)
let surface_point (a : Motion.t) t (face, (x, y, z)) =
  let faces = a.solid.polyhedron.faces in
  let corners = snd faces.(face mod Array.length faces) in
  let at i = Motion.point a t (Solid.vertex a.solid corners.(i)) in
  let x, y, z = if x + y + z = 0 then (1, 1, 1) else (x, y, z) in
  let share k i = Vec.scale (ratio k (x + y + z)) (at i) in
  Vec.add (share x 0) (Vec.add (share y 1) (share z 2))

(* How fast a point of the solid moves, nearly. *)
let speed m t p =
  let h = power_of_two 30 in
  Vec.scale (Rat.div Rat.one h) (Vec.sub (Motion.point m (Rat.add t h) p) (Motion.point m t p))

(* A vertex of B comes to a point of A's surface, or to [slip] away from it along the normal, at the instant [t],
   often on the grid: along the surface ([graze]) or from somewhere. *)
let meeting solid =
  let make a b ((face, _) as place) (corner, t, slip) (graze, way) (span, grid) =
    let point = surface_point a t place in
    let p = Solid.vertex b.Motion.solid (corner mod Array.length b.solid.vertices) in
    let faces = a.Motion.solid.polyhedron.faces in
    let normal = a.solid.normals.(face mod Array.length faces) in
    let normal = Quaternion.apply (Motion.rotation a t) (Ivec.to_vec normal) in
    let goal = Vec.axpy slip normal point in
    let way =
      if graze then
        (* what the vertex needs to move along the surface as it is seen from A *)
        let back = Quaternion.inverse (Motion.rotation a t) in
        let local = Quaternion.apply back (Vec.sub point (Motion.reference a t)) in
        let along = Vec.cross normal way in
        Vec.sub (Vec.add along (speed a t local)) (speed b t p)
      else way
    in
    let b = { b with velocity = way } in
    let centre = Vec.sub goal (Motion.point b t p) in
    { a; b = { b with centre = Vec.add b.centre centre }; span; grid }
  in
  let upto n = Gen.map (fun k -> ratio k n) Gen.(0 -- n) in
  let times = Gen.oneof [ upto 8; upto 997 ] in
  let slips =
    Gen.oneof
      [ Gen.return Rat.zero;
        Gen.map2 (fun k up -> if up then power_of_two k else Rat.neg (power_of_two k)) Gen.(15 -- 60) Gen.bool ]
  in
  let corner = Gen.int_bound 100 in
  let weights = Gen.triple (Gen.int_bound 2) (Gen.int_bound 2) (Gen.int_bound 2) in
  Gen.bind (Gen.pair (motion solid zero zero) (motion solid zero zero)) (fun (a, b) ->
      Gen.map3
        (fun place at (way, limits) -> make a b place at way limits)
        (Gen.pair corner weights) (Gen.triple corner times slips)
        (Gen.pair (Gen.pair Gen.bool (vector 6 2)) (Gen.pair span grid)))

(* Solids that touch now, and turn or slide about each other. *)
let resting =
  let motion (p : Placed.t) (velocity, spin, since) : Motion.t =
    let arm = Vec.neg (Quaternion.apply p.turned p.solid.Solid.centroid) in
    { solid = p.solid; turned = p.turned; arm; centre = Vec.sub p.at arm; velocity; spin; since }
  in
  let along axis = Gen.map (fun k -> Vec.scale k axis) (quotient 2 7) in
  let spins = Gen.oneof [ zero; along (Vec.of_ints 1 0 0); along (Vec.of_ints 0 0 1); vector 2 7 ] in
  let flight = Gen.triple (Gen.oneof [ zero; vector 1 1 ]) spins (Gen.return Rat.zero) in
  Gen.map3
    (fun pair (f, g) (span, grid) ->
       Option.map (fun (a, b) -> { a = motion a f; b = motion b g; span; grid }) pair)
    Bodies.touching_pair (Gen.pair flight flight) (Gen.pair span grid)

(* {1 Other sizes, other places} *)

let resized k c =
  let length = Vec.scale k in
  let motion id (m : Motion.t) =
    { m with
      solid = scaled k m.solid id; arm = length m.arm; centre = length m.centre; velocity = length m.velocity }
  in
  { c with a = motion 200 c.a; b = motion 201 c.b }

let elsewhere at c =
  let move (m : Motion.t) = { m with centre = Vec.add m.centre at } in
  { c with a = move c.a; b = move c.b }

let changed case =
  let change = function
    | 0 -> resized (Rat.of_int 1_000_000)
    | 1 -> resized (ratio 1 1_000_000)
    | 2 -> elsewhere (Vec.of_ints 1_000_000 (-3_000_000) 1)
    | _ -> resized (Rat.make Z.one (Z.shift_left Z.one 300))
  in
  Gen.map2 (fun k c -> change k c) (Gen.int_bound 3) case

(* {1 Proofs} *)

(* The exact gap along a direction. *)
let gap a b t n =
  let extreme choose m =
    let heights = Array.map (Vec.dot n) (Motion.vertices m t) in
    Array.fold_left choose heights.(0) heights
  in
  Rat.sub (extreme Rat.min b) (extreme Rat.max a)

(* For as long as a plane can be proved to keep them apart, at an instant and with a rate that may be a bad one, it
   does so. B is drawn near along the direction, so that not much is left but errors. *)
let proofs_hold (c, (at, rate, left)) =
  let end_ = Float_box.up c.span in
  let start = Float.of_int at *. end_ /. 16. in
  let exact x = Q.of_float x in
  let searched (b : Motion.t) =
    match Flight.make c.a b end_ with
    | None -> None
    | Some flight ->
      Flight.move flight start;
      let simplex = Gjk.make flight and plane = Separation.make flight in
      (match Gjk.search simplex with
       | Apart _ -> Heading.aim plane simplex
       | Near -> Gjk.between flight plane.n);
      Some plane
  in
  match searched c.b with
  | None -> true
  | Some plane -> (
      let n = Array.copy plane.n in
      let direction x = Vec.make (exact x.(0)) (exact x.(1)) (exact x.(2)) in
      let now = gap c.a c.b (exact start) (direction n) in
      let size = Rat.to_float (Vec.norm2 (direction n)) in
      let closer = Rat.div (Rat.sub (Rat.mul (power_of_two left) c.a.solid.radius) now) (exact size) in
      let b = { c.b with centre = Vec.axpy closer (direction n) c.b.centre } in
      match Flight.make c.a b end_ with
      | None -> true
      | Some flight ->
        Flight.move flight start;
        let near = Separation.make flight in
        Array.blit n 0 near.n 0 3;
        List.iteri (fun k r -> near.rate.(k) <- plane.rate.(k) +. r) rate;
        let rest = end_ -. start in
        let longest =
          if Separation.holds near rest then rest
          else
            let rec search low high k =
              let middle = 0.5 *. (low +. high) in
              if k = 0 then low
              else if Separation.holds near middle then search middle high (k - 1)
              else search low middle (k - 1)
            in
            search 0. rest 40
        in
        let holds k =
          let delay = Rat.mul (exact longest) (ratio k 8) in
          let n = Vec.axpy delay (direction near.rate) (direction n) in
          Rat.sign (gap c.a b (Rat.add (exact start) delay) n) > 0
        in
        (longest = 0. && not (Separation.holds near 0.)) || List.for_all holds [ 0; 1; 3; 6; 7; 8 ])

let proof =
  let rate = Gen.map (fun k -> float_of_int k /. 1000.) Gen.(-300 -- 300) in
  let rates = Gen.oneof [ Gen.return [ 0.; 0.; 0. ]; Gen.list_repeat 3 rate ] in
  Gen.triple Gen.(0 -- 15) rates (Gen.oneof [ Gen.(0 -- 12); Gen.(30 -- 56) ])

(* {1 Bounds} *)

let sound_bound c =
  let bound = Cast.speed_bound c.a c.b in
  let fastest = ref Rat.zero in
  let h = power_of_two 10 in
  let see t =
    let at m t = Motion.vertices m t in
    let a, a' = (at c.a t, at c.a (Rat.add t h)) and b, b' = (at c.b t, at c.b (Rat.add t h)) in
    Array.iteri
      (fun i p ->
         Array.iteri
           (fun j q ->
              let moved = Vec.sub (Vec.sub b'.(j) a'.(i)) (Vec.sub q p) in
              fastest := Rat.max !fastest (Rat.div (Vec.norm2 moved) (Rat.mul h h)))
           b)
      a
  in
  List.iter see [ Rat.zero; ratio 1 2 ];
  Rat.compare !fastest (Rat.mul bound bound) <= 0
  && Rat.bits bound < 40
  && Rat.equal bound (Cast.speed_bound c.b c.a)

let right_grid (c, resolution) =
  let bound = Cast.speed_bound c.a c.b and k = Cast.grid c.a c.b ~resolution in
  let enough k = Rat.compare (Rat.mul bound (power_of_two k)) resolution <= 0 in
  enough k && (k = 0 || not (enough (k - 1)))

let property ~count name gen holds = QCheck2.Test.make ~count ~name ~print gen holds

let suite =
  let cases =
    Scc_test_support.Property.cases
      [
        QCheck2.Test.make ~count:100 ~name:"what is proved is so"
          ~print:(fun (c, _) -> print c)
          (Gen.pair (flying any_solid) proof) proofs_hold;
        property ~count:200 "flying solids" (flying any_solid) agrees;
        property ~count:6 "flying hulls" (flying hulls) agrees;
        property ~count:400 "a vertex to a place on the surface" (meeting any_solid) agrees;
        property ~count:8 "a vertex to a place on the surface of a hull" (meeting hulls) agrees;
        QCheck2.Test.make ~count:200 ~name:"a grid that counts from before"
          ~print:(fun (c, phase) -> print c ^ "\nphase " ^ Rat.to_string phase)
          (Gen.pair
             (Gen.oneof [ flying any_solid; meeting any_solid ])
             (Gen.oneof
                [ Gen.map (fun k -> ratio k 97) Gen.(0 -- 97); Gen.map (fun k -> ratio k 1024) Gen.(0 -- 1024) ]))
          agrees_later;
        QCheck2.Test.make ~count:80 ~name:"touching at first"
          ~print:(QCheck2.Print.option print)
          resting
          (Option.fold ~none:true ~some:agrees);
        property ~count:60 "far away, great and small" (changed (flying any_solid)) agrees;
        property ~count:60 "far away, great and small: a vertex to a place" (changed (meeting simple)) agrees;
        property ~count:20 "no point is faster than the bound" (flying any_solid) sound_bound;
        QCheck2.Test.make ~count:20 ~name:"the grid is the coarsest that will do"
          (Gen.pair (flying any_solid) (Gen.map2 (fun a b -> ratio a b) Gen.(1 -- 99) Gen.(1 -- 1_000_000)))
          right_grid;
      ]
  in
  ("cast", [ ("cast", cases) ])
