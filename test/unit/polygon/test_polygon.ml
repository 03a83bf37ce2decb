(* Convex partitions against brute force: all sets of diagonals that do not cross, of small polygons. *)

open Scc_exact
open Scc_polygon
open Scc_test_support

let point (x, y) = { Grid.x = Rat.of_int x; y = Rat.of_int y }
let ring first n = Array.init n (fun k -> first + k)

(* {1 A second implementation: integers, no shared code} *)

type plane = (int * int) array

let cross (p : plane) a b c =
  let (xa, ya), (xb, yb), (xc, yc) = (p.(a), p.(b), p.(c)) in
  ((xb - xa) * (yc - ya)) - ((yb - ya) * (xc - xa))

let dot (p : plane) a b c =
  let (xa, ya), (xb, yb), (xc, yc) = (p.(a), p.(b), p.(c)) in
  ((xb - xa) * (xc - xa)) + ((yb - ya) * (yc - ya))

let on_segment p a b c = cross p a b c = 0 && dot p c a b <= 0
let sign = Int.compare

let meet p (a, b) (c, d) =
  (sign (cross p a b c) 0 * sign (cross p a b d) 0 < 0 && sign (cross p c d a) 0 * sign (cross p c d b) 0 < 0)
  || on_segment p a b c || on_segment p a b d || on_segment p c d a || on_segment p c d b

let edges ring = List.mapi (fun k a -> (a, List.nth ring ((k + 1) mod List.length ring))) ring

let simple p ring =
  let all = edges ring in
  let disjoint (a, b) (c, d) =
    if b = c then (not (on_segment p a b d)) && not (on_segment p b d a)
    else if d = a then (not (on_segment p a b c)) && not (on_segment p c d b)
    else not (meet p (a, b) (c, d))
  in
  List.for_all (fun e -> List.for_all (fun f -> e == f || disjoint e f) all) all

let area2 p ring = List.fold_left (fun sum (a, b) -> sum + cross [| (0, 0); p.(a); p.(b) |] 0 1 2) 0 (edges ring)

(* Twice the coordinates of the midpoint, in or out of the polygon whose coordinates are doubled. *)
let holds_midpoint p ring a b =
  let (xa, ya), (xb, yb) = (p.(a), p.(b)) in
  let x = xa + xb and y = ya + yb in
  let crossing (u, v) =
    let xu, yu = p.(u) and xv, yv = p.(v) in
    let xu = 2 * xu and yu = 2 * yu and xv = 2 * xv and yv = 2 * yv in
    yu > y <> (yv > y)
    &&
    (* x < xu + (y - yu)(xv - xu)/(yv - yu) *)
    let left = (x - xu) * (yv - yu) and right = (y - yu) * (xv - xu) in
    if yv > yu then left < right else left > right
  in
  List.length (List.filter crossing (edges ring)) mod 2 = 1

let diagonal p ring a b =
  let touches (u, v) =
    if u = a || v = a || u = b || v = b then false else meet p (a, b) (u, v)
  in
  let through c = c <> a && c <> b && on_segment p a b c in
  (not (List.exists touches (edges ring))) && (not (List.exists through ring)) && holds_midpoint p ring a b

let convex p ring =
  let n = List.length ring in
  let corner k = List.nth ring (k mod n) in
  let straight_on k = cross p (corner k) (corner (k + 1)) (corner (k + 2)) >= 0 in
  List.for_all straight_on (List.init n Fun.id)

let least p ring =
  let known = Hashtbl.create 64 in
  let rec least ring =
    match Hashtbl.find_opt known ring with
    | Some k -> k
    | None ->
      let k = if convex p ring then 1 else cut ring in
      Hashtbl.add known ring k;
      k
  and cut ring =
    let n = List.length ring in
    let best = ref max_int in
    for i = 0 to n - 1 do
      for j = i + 2 to n - 1 do
        if (i > 0 || j < n - 1) && diagonal p ring (List.nth ring i) (List.nth ring j) then begin
          let one = List.filteri (fun k _ -> k >= i && k <= j) ring in
          let other = List.filteri (fun k _ -> k <= i || k >= j) ring in
          best := min !best (least one + least other)
        end
      done
    done;
    !best
  in
  least ring

(* {1 Random polygons} *)

(* Of distinct points a tour, of which two edges that cross are turned around until none do. *)
let untangled p n =
  let tour = Array.init n Fun.id in
  let rec improve left =
    if left = 0 then None
    else
      let ring = Array.to_list tour in
      if simple p ring then Some ring
      else begin
        let changed = ref false in
        for i = 0 to n - 2 do
          for j = i + 2 to n - 1 do
            if (not !changed) && not (i = 0 && j = n - 1) then
              if meet p (tour.(i), tour.(i + 1)) (tour.(j), tour.((j + 1) mod n)) then begin
                let part = Array.sub tour (i + 1) (j - i) in
                Array.iteri (fun k v -> tour.(j - k) <- v) part;
                changed := true
              end
          done
        done;
        if !changed then improve (left - 1) else None
      end
  in
  improve 60

let generator ~corners ~size =
  let open QCheck2.Gen in
  let* n = corners in
  let* points = array_size (return n) (pair (int_range 0 size) (int_range 0 size)) in
  return points

let oriented p ring = if area2 p ring > 0 then ring else List.rev ring

let read p rings =
  match Polygon.make (Array.map point p) (List.map Array.of_list rings) with
  | Ok polygon -> polygon
  | Error _ -> QCheck2.Test.fail_report "a simple polygon is refused"

(* {1 What every partition is} *)

let is_partition p rings pieces =
  let pieces = List.map Array.to_list pieces in
  let directed = Hashtbl.create 64 in
  let enter e = Hashtbl.replace directed e (1 + Option.value ~default:0 (Hashtbl.find_opt directed e)) in
  List.iter (fun piece -> List.iter enter (edges piece)) pieces;
  let times e = Option.value ~default:0 (Hashtbl.find_opt directed e) in
  let boundary = List.concat_map edges rings in
  let paired (u, v) k = k = 1 && (times (v, u) = 1 || List.mem (u, v) boundary) in
  let total = List.fold_left (fun sum piece -> sum + area2 p piece) 0 pieces in
  List.for_all (fun piece -> convex p piece && area2 p piece > 0 && simple p piece) pieces
  && List.for_all (fun e -> times e = 1) boundary
  && Hashtbl.fold (fun e k ok -> ok && paired e k) directed true
  && total = List.fold_left (fun sum ring -> sum + area2 p ring) 0 rings

let optimal name ~count ~corners ~size =
  QCheck2.Test.make ~count ~name
    ~print:QCheck2.Print.(array (pair int int))
    (generator ~corners ~size)
    (fun p ->
       let n = Array.length p in
       match untangled p n with
       | None -> true
       | Some ring ->
         let ring = oriented p ring in
         let pieces = Partition.convex (read p [ ring ]) in
         is_partition p [ ring ] pieces && List.length pieces = least p ring)

let reflex p ring =
  let n = List.length ring in
  let corner k = List.nth ring (k mod n) in
  List.length (List.filter (fun k -> cross p (corner k) (corner (k + 1)) (corner (k + 2)) < 0)
                 (List.init n Fun.id))

(* A large polygon with holes: quadrilaterals, and others, in cells of a grid inside of a frame with teeth. *)
let holed =
  QCheck2.Test.make ~count:150 ~name:"with holes: a partition, within its bound"
    QCheck2.Gen.(pair (int_range 1 5) (list_size (return 40) (pair (int_range 1 8) (int_range 1 8))))
    (fun (h, offsets) ->
       let offset k = List.nth offsets k in
       let frame = [ (0, 0); (30 * h, 0); (30 * h, 40); (15 * h, 30); (0, 40) ] in
       let hole k =
         let x = (30 * k) + 5 in
         let at c (dx, dy) = let ox, oy = offset ((4 * k) + c) in (x + dx + ox, dy + oy) in
         [ at 0 (0, 2); at 1 (0, 12); at 2 (12, 12); at 3 (12, 2) ]
       in
       let holes = List.init h hole in
       let p = Array.of_list (frame @ List.concat holes) in
       let rings = List.init 5 Fun.id :: List.init h (fun k -> List.init 4 (fun c -> 5 + (4 * k) + c)) in
       match Polygon.make (Array.map point p) (List.map Array.of_list rings) with
       | Error _ -> QCheck2.assume_fail ()
       | Ok polygon ->
         let outer = oriented p (List.hd rings) in
         let inner = List.map (fun ring -> List.rev (oriented p ring)) (List.tl rings) in
         let rings = outer :: inner in
         let pieces = Partition.convex polygon in
         let r = List.fold_left (fun sum ring -> sum + reflex p ring) 0 rings in
         let k = List.length pieces in
         is_partition p rings pieces && k <= (2 * r) + 1 && 2 * (k - 1 + h) >= r)

(* {1 By hand} *)

let count points rings =
  match Polygon.make (Array.map point points) rings with
  | Ok polygon -> List.length (Partition.convex polygon)
  | Error _ -> Alcotest.fail "refused"

let by_hand name expected points rings =
  Alcotest.test_case name `Quick (fun () -> Alcotest.(check int) name expected (count points rings))

let square x y a = [| (x, y); (x + a, y); (x + a, y + a); (x, y + a) |]

(* The four-armed cross has four reflex corners, and two cuts take two of them each. *)
let plus =
  [| (1, 0); (2, 0); (2, 1); (3, 1); (3, 2); (2, 2); (2, 3); (1, 3); (1, 2); (0, 2); (0, 1); (1, 1) |]

let ell = [| (0, 0); (2, 0); (2, 1); (1, 1); (1, 2); (0, 2) |]
let clamp = [| (0, 0); (4, 0); (4, 1); (1, 1); (1, 3); (4, 3); (4, 4); (0, 4) |]

let fault name expected points rings =
  Alcotest.test_case name `Quick (fun () ->
      match (Polygon.make (Array.map point points) rings, expected) with
      | Error (Short_ring k), `Short l -> Alcotest.(check int) name l k
      | Error (Same_place (a, b)), `Same (c, d) ->
        Alcotest.(check (pair int int)) name (c, d) (min a b, max a b)
      | Error (Crossing _), `Crossing -> ()
      | Error (Outside k), `Outside l -> Alcotest.(check int) name l k
      | _ -> Alcotest.fail "another outcome")

let hand =
  [
    by_hand "a square" 1 (square 0 0 1) [ ring 0 4 ];
    by_hand "clockwise" 1 (square 0 0 1) [ [| 3; 2; 1; 0 |] ];
    by_hand "straight angles are no cuts" 1 [| (0, 0); (1, 0); (2, 0); (2, 2); (1, 2); (0, 2) |] [ ring 0 6 ];
    by_hand "an L" 2 ell [ ring 0 6 ];
    by_hand "a cross" 3 plus [ ring 0 12 ];
    by_hand "a clamp" 3 clamp [ ring 0 8 ];
    by_hand "a frame" 4 (Array.append (square 0 0 4) (square 1 1 2)) [ ring 0 4; ring 4 4 ];
    by_hand "a triangle in a triangle" 3
      [| (0, 0); (12, 0); (0, 12); (2, 2); (2, 5); (5, 2) |]
      [ ring 0 3; ring 3 3 ];
  ]

let faults =
  [
    fault "two corners" (`Short 0) [| (0, 0); (1, 0) |] [ ring 0 2 ];
    fault "one place twice" (`Same (0, 3)) [| (0, 0); (1, 0); (1, 1); (0, 0) |] [ ring 0 4 ];
    fault "a bow tie" `Crossing [| (0, 0); (2, 2); (2, 0); (0, 2) |] [ ring 0 4 ];
    fault "a spike" `Crossing [| (0, 0); (2, 0); (4, 0); (1, 0) |] [ ring 0 4 ];
    fault "a corner on an edge" `Crossing [| (0, 0); (4, 0); (4, 4); (2, 0); (0, 4) |] [ ring 0 5 ];
    fault "a hole outside" (`Outside 1) (Array.append (square 0 0 4) (square 9 9 2)) [ ring 0 4; ring 4 4 ];
    fault "a hole in a hole" (`Outside 1)
      (Array.concat [ square 0 0 9; square 2 2 1; square 1 1 7 ])
      [ ring 0 4; ring 4 4; ring 8 4 ];
    fault "holes that touch" `Crossing
      (Array.concat [ square 0 0 9; square 1 1 2; square 3 2 2 ])
      [ ring 0 4; ring 4 4; ring 8 4 ];
  ]

let () =
  let open QCheck2.Gen in
  Alcotest.run "polygon"
    [
      ("by hand", hand);
      ("faults", faults);
      ( "properties",
        Property.cases
          [
            optimal "the fewest pieces, corners on a small grid" ~count:1500 ~corners:(int_range 4 9) ~size:4;
            optimal "the fewest pieces, corners in general position" ~count:1500 ~corners:(int_range 5 9)
              ~size:1000;
            holed;
          ] );
    ]
