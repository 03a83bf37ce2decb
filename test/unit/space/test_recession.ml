(* Whether two sets recede from each other, against all combinations of differences of their points. *)

open Scc_exact
open Scc_state_space
module Gen = QCheck2.Gen

(* {1 By brute force} *)

let dot a b = Array.fold_left Rat.add Rat.zero (Array.map2 Rat.mul a b)

(* The solution of the normal equations, if there is one and no more. *)
let solve rows right =
  let k = Array.length right in
  let m = Array.mapi (fun i row -> Array.append row [| right.(i) |]) rows in
  let exception Singular in
  try
    for c = 0 to k - 1 do
      let rec pivot r =
        if r = k then raise Singular else if Rat.sign m.(r).(c) <> 0 then r else pivot (r + 1)
      in
      let p = pivot c in
      let row = m.(p) in
      m.(p) <- m.(c);
      m.(c) <- Array.map (fun x -> Rat.div x row.(c)) row;
      for r = 0 to k - 1 do
        if r <> c then begin
          let f = m.(r).(c) in
          m.(r) <- Array.map2 (fun x y -> Rat.sub x (Rat.mul f y)) m.(r) m.(c)
        end
      done
    done;
    Some (Array.map (fun row -> row.(k)) m)
  with Singular -> None

let rec subsets k = function
  | _ when k = 0 -> [ [] ]
  | [] -> []
  | x :: rest -> List.map (fun s -> x :: s) (subsets (k - 1) rest) @ subsets k rest

(* The square of the distance of a point from a cone: the nearest point is the projection on the span of some of
   the vectors, with coefficients that are not negative, and all such projections are in the cone. *)
let distance2 vectors point =
  let of_subset chosen =
    let v = Array.of_list chosen in
    match solve (Array.map (fun a -> Array.map (dot a) v) v) (Array.map (dot point) v) with
    | Some x when Array.for_all (fun c -> Rat.sign c >= 0) x ->
      let minus rest (c, a) = Array.map2 (fun r s -> Rat.sub r (Rat.mul c s)) rest a in
      let rest = List.fold_left minus point (List.map2 (fun c a -> (c, a)) (Array.to_list x) chosen) in
      Some (dot rest rest)
    | Some _ | None -> None
  in
  let k = Array.length point in
  let all = List.concat_map (fun k -> subsets k vectors) (List.init (k + 1) Fun.id) in
  List.fold_left Rat.min (dot point point) (List.filter_map of_subset all)

let of_vec (v : Vec.t) = [| v.x; v.y; v.z |]

let zero_within d =
  let lifted = List.map (fun v -> Array.append v [| Rat.one |]) d in
  Rat.sign (distance2 lifted (Array.map Rat.of_int [| 0; 0; 0; 1 |])) = 0

type point = int * int * int
type case = { one : point list; two : point list; w : point; a : int; b : int; margin : int }

let vec (x, y, z) = Vec.of_ints x y z

let differences c =
  let cube = if c.margin = 0 then [ 0 ] else [ -c.margin; c.margin ] in
  let with_z x y = List.map (fun z -> (x, y, z)) cube in
  let corners = List.concat_map (fun x -> List.concat_map (with_z x) cube) cube in
  let minus (x, y, z) (u, v, w) = (x - u, y - v, z - w) and plus (x, y, z) (u, v, w) = (x + u, y + v, z + w) in
  List.concat_map (fun h -> List.concat_map (fun g -> List.map (plus (minus h g)) corners) c.one) c.two
  |> List.sort_uniq Stdlib.compare
  |> List.map (fun d -> of_vec (vec d))

(* The radius is a whole number: a and b are squares. *)
let expected c =
  let d = differences c in
  let r = Rat.of_int (c.a + c.b) in
  let beyond = Rat.compare (distance2 d (of_vec (Vec.neg (vec c.w)))) (Rat.mul r r) > 0 in
  (beyond, beyond && zero_within d)

let side points velocity root =
  let place = Vec.of_ints 1 2 3 in
  let around = Array.of_list (List.map (fun p -> Vec.sub (vec p) place) points) in
  { Recession.bodies = [ (place, Recession.body around) ]; velocity; spread2 = Rat.of_int (root * root) }

let told c =
  let u = Vec.of_ints 5 (-3) 1 in
  Recession.for_ever ~margin:(Rat.of_int c.margin) (side c.one u c.a) (side c.two (Vec.add u (vec c.w)) c.b)

let case =
  let open Gen in
  let near = int_range (-2) 2 in
  let point = triple near near near in
  let* margin = frequencyl [ (4, 0); (1, 1) ] in
  let points = list_size (int_range 1 (if margin = 0 then 3 else 1)) point in
  let* one = points and* two = points and* far = oneofl [ 0; 0; 1; 2; 4; 6 ] in
  let* w = triple (int_range (-4) 4) (int_range (-3) 3) (int_range (-3) 3) in
  let+ a = oneofl [ 0; 1; 2 ] and+ b = oneofl [ 0; 1 ] in
  { one; two = List.map (fun (x, y, z) -> (x + far, y, z)) two; w; a; b; margin }

let print c =
  let points l = String.concat " " (List.map (fun p -> Vec.to_string (vec p)) l) in
  let w = Vec.to_string (vec c.w) in
  Printf.sprintf "%s | %s | %s | %d %d | %d" (points c.one) (points c.two) w c.a c.b c.margin

(* How often each outcome came up: apart, not apart, and not apart for the one reason that they touch. *)
let seen = Array.make 3 0

let by_all_directions =
  QCheck2.Test.make ~name:"by all directions" ~count:1500 ~print case (fun c ->
      let beyond, touch = expected c in
      let outcome = if not beyond then 1 else if touch then 2 else 0 in
      seen.(outcome) <- seen.(outcome) + 1;
      Bool.equal (told c) (outcome = 0))

let enough () =
  Array.iteri (fun i n -> if n < 5 then Alcotest.failf "outcome %d came up %d times" i n) seen

let () =
  Alcotest.run "recession"
    [
      ( "recession",
        Scc_test_support.Property.cases [ by_all_directions ] @ [ Alcotest.test_case "enough" `Quick enough ] );
    ]
