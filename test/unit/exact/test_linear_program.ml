(* Linear programs against an enumeration: the least cost is that of a vertex, where so many of the conditions hold
   with equality that they leave one point; and it is bounded iff no ray that leads away for ever lowers it. *)

open Scc_exact
module Gen = QCheck2.Gen

let whole = Rat.of_int
let dot a b = List.fold_left2 (fun s x y -> Rat.add s (Rat.mul x y)) Rat.zero a b

(* {1 Slanted systems: x >= 0 in two or three variables, and a.x <= b or a.x = b} *)

type relation = At_most | Exactly
type condition = { normal : Rat.t list; relation : relation; bound : Rat.t }
type system = { conditions : condition list; cost : Rat.t list }

let dimension s = List.length s.cost

(* With the variables, which are not negative. *)
let all_conditions s =
  let n = dimension s in
  let minus i = List.init n (fun j -> if i = j then whole (-1) else Rat.zero) in
  List.init n (fun i -> { normal = minus i; relation = At_most; bound = Rat.zero }) @ s.conditions

let meets x c =
  let d = Rat.compare (dot c.normal x) c.bound in
  match c.relation with At_most -> d <= 0 | Exactly -> d = 0

(* {2 By enumeration} *)

let rec choose k list =
  match (k, list) with
  | 0, _ -> [ [] ]
  | _, [] -> []
  | _, x :: rest -> List.map (List.cons x) (choose (k - 1) rest) @ choose k rest

(* The one solution of as many equations as unknowns, by elimination; [None] if there are more or none. *)
let rec solve equations =
  let leads (a, _) = match a with [] -> false | x :: _ -> Rat.sign x <> 0 in
  match equations with
  | [] -> Some []
  | _ -> (
      match List.partition leads equations with
      | [], _ -> None
      | (a, b) :: more, rest ->
        let first = List.hd a in
        let without (c, d) =
          let factor = Rat.div (List.hd c) first in
          let less x y = Rat.sub y (Rat.mul factor x) in
          (List.map2 less (List.tl a) (List.tl c), less b d)
        in
        let back tail =
          let known = dot (List.tl a) tail in
          Rat.div (Rat.sub b known) first :: tail
        in
        Option.map back (solve (List.map without (more @ rest))))

let points conditions n =
  choose n conditions |> List.filter_map (fun cs -> solve (List.map (fun c -> (c.normal, c.bound)) cs))

let vertices s =
  let all = all_conditions s in
  List.filter (fun x -> List.for_all (meets x) all) (points all (dimension s))

(* Directions in which one may go for ever, of length 1 in the sum of coordinates: the vertices of them. *)
let rays s =
  let homogeneous = List.map (fun c -> { c with bound = Rat.zero }) s.conditions in
  let sum = { normal = List.map (fun _ -> Rat.one) s.cost; relation = Exactly; bound = Rat.one } in
  vertices { s with conditions = sum :: homogeneous }

type answer = Empty | Without_bound | Least of Rat.t

let enumerated s =
  match List.map (dot s.cost) (vertices s) with
  | [] -> Empty
  | first :: more ->
    if List.exists (fun d -> Rat.sign (dot s.cost d) < 0) (rays s) then Without_bound
    else Least (List.fold_left Rat.min first more)

(* {2 By the program} *)

(* Slack makes equations of inequalities; right sides are not to be negative. *)
let solved s =
  let n = dimension s and m = List.length s.conditions in
  let row i c =
    let slack j = match c.relation with At_most when i = j -> Rat.one | At_most | Exactly -> Rat.zero in
    let row = Array.of_list (c.normal @ List.init m slack) in
    if Rat.sign c.bound < 0 then Array.map Rat.neg row else row
  in
  let rows = Array.of_list (List.mapi row s.conditions) in
  let right = Array.of_list (List.map (fun c -> Rat.abs c.bound) s.conditions) in
  let cost = Array.init (n + m) (fun j -> if j < n then List.nth s.cost j else Rat.zero) in
  match Linear_program.least rows right ~cost with
  | Some least -> Least least
  | None -> Empty
  | exception Scc_base.Bug.Bug _ -> Without_bound

let show = function
  | Empty -> "empty"
  | Without_bound -> "without bound"
  | Least q -> Rat.to_string q

(* {2 At random} *)

let number = Gen.(map2 (fun n d -> Rat.make (Z.of_int n) (Z.of_int d)) (int_range (-4) 4) (int_range 1 3))

let print s =
  let list l = String.concat " " (List.map Rat.to_string l) in
  let line c =
    Printf.sprintf "%s %s %s" (list c.normal) (match c.relation with At_most -> "<=" | Exactly -> "=")
      (Rat.to_string c.bound)
  in
  String.concat "\n" (List.map line s.conditions @ [ "cost " ^ list s.cost ])

let condition n =
  let open Gen in
  let* normal = list_repeat n number in
  let* relation = frequencyl [ (4, At_most); (1, Exactly) ] in
  let* bound = frequency [ (1, return Rat.zero); (4, number) ] in
  return { normal; relation; bound }

(* Some say what others say already, and many meet in one vertex. *)
let with_more conditions =
  let open Gen in
  let* factors = list_size (int_range 0 2) (map whole (int_range 1 3)) in
  let again f c = { c with normal = List.map (Rat.mul f) c.normal; bound = Rat.mul f c.bound } in
  return (conditions @ List.concat_map (fun f -> List.map (again f) conditions) factors)

let system =
  let open Gen in
  let* n = int_range 2 3 in
  let* conditions = list_size (int_range 1 4) (condition n) in
  let* degenerate = frequencyl [ (3, false); (1, true) ] in
  let* conditions = if degenerate then with_more conditions else return conditions in
  let* cost = list_repeat n number in
  return { conditions; cost }

let random =
  QCheck2.Test.make ~count:4000 ~name:"the least cost is that of a vertex" ~print system (fun s ->
      let expected = show (enumerated s) and found = show (solved s) in
      if String.equal expected found then true
      else QCheck2.Test.fail_reportf "%s by enumeration, %s by the program" expected found)

(* Each kind is among them. *)
let kinds () =
  let rand = Stdlib.Random.State.make [| 7 |] in
  let all = List.map enumerated (Gen.generate ~n:1000 ~rand system) in
  let count test = List.length (List.filter test all) in
  let many what test = Alcotest.(check bool) what true (count test > 50) in
  many "empty" (fun a -> a = Empty);
  many "without bound" (fun a -> a = Without_bound);
  many "bounded" (function Least q -> Rat.sign q <> 0 | Empty | Without_bound -> false)

(* {1 By hand} *)

let at_most normal bound = { normal = List.map whole normal; relation = At_most; bound = whole bound }
let exactly normal bound = { normal = List.map whole normal; relation = Exactly; bound = whole bound }

let by_hand () =
  let check what expected conditions cost =
    Alcotest.(check string) what expected (show (solved { conditions; cost = List.map whole cost }))
  in
  check "a slanted edge" "-7/5" [ at_most [ 2; 1 ] 2; at_most [ 1; 3 ] 3 ] [ -1; -1 ];
  check "a vertex of three planes" "-1" [ at_most [ 1; 1; 0 ] 1; at_most [ 0; 1; 1 ] 1; at_most [ 1; 0; 1 ] 1 ]
    [ -1; -1; 0 ];
  check "empty" "empty" [ at_most [ 1; 2 ] 1; at_most [ -1; -1 ] (-2) ] [ 0; 0 ];
  check "a strip" "without bound" [ at_most [ 1; -1 ] 0 ] [ 0; -1 ];
  check "bounded on a set that is not" "1/3" [ at_most [ -3; 0 ] (-1) ] [ 1; 2 ];
  check "a point" "5" [ exactly [ 1; 1 ] 3; exactly [ 1; -1 ] 1 ] [ 1; 3 ];
  check "an equation twice" "2" [ exactly [ 1; 2 ] 2; exactly [ 2; 4 ] 4 ] [ 1; 2 ];
  check "equations that contradict each other" "empty" [ exactly [ 1; 2 ] 2; exactly [ 2; 4 ] 5 ] [ 1; 2 ];
  check "nothing but zero" "0" [ at_most [ 1; 1; 1 ] 0 ] [ -1; -1; -1 ];
  (* Dantzig's rule goes round for ever here (Beale). *)
  let over n d = Rat.make (Z.of_int n) (Z.of_int d) in
  let row a b c d = { (at_most [] 0) with normal = [ a; whole b; c; whole d ] } in
  let conditions =
    [ row (over 1 4) (-60) (over (-1) 25) 9; row (over 1 2) (-90) (over (-1) 50) 3; at_most [ 0; 0; 1; 0 ] 1 ]
  in
  let cost = [ over (-3) 4; whole 150; over (-1) 50; whole 6 ] in
  Alcotest.(check string) "a cycle of pivots" "-1/20" (show (solved { conditions; cost }))

let () =
  Alcotest.run "linear programs"
    [
      ("random", Scc_test_support.Property.cases [ random ]);
      ( "cases",
        [ Alcotest.test_case "by hand" `Quick by_hand; Alcotest.test_case "each kind is tried" `Quick kinds ] );
    ]
