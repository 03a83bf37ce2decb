(* Operations on formulas: orders, renaming, what they look at. *)

open Scc_exact
open Scc_calculus
open Scc_property
open Property
module Gen = QCheck2.Gen

(* {1 Random formulas, over few leaves so that many are nearly alike} *)

let leaf = Gen.int_range 0 2
let name = Gen.oneofl [ "a"; "b" ]
let axis = Gen.oneofl [ X; Y; Z ]
let comparison : Law.comparison Gen.t = Gen.oneofl Law.[ Lt; Le; Gt; Ge; Eq; Ne ]
let change = Gen.oneofl [ Made; Released_weakly; Released_strongly; Released ]

let ends =
  Gen.oneof
    [ Gen.return Any; Gen.map (fun i -> One i) leaf; Gen.map2 (fun i j -> Two (i, j)) leaf leaf ]

let event =
  Gen.oneof
    [ Gen.map3 (fun c n e -> Bond (c, n, e)) change (Gen.opt name) ends; Gen.map (fun e -> Bounce e) ends ]

let few g = Gen.list_size (Gen.int_range 0 3) g

let quantity =
  Gen.oneof
    [
      Gen.map2 (fun n p -> Bonds (n, p)) (Gen.opt name) (Gen.opt (Gen.pair leaf leaf));
      Gen.map (fun i -> Size i) leaf; Gen.return Processes; Gen.return Energy; Gen.return Time;
      Gen.map2 (fun a i -> Position (a, i)) axis leaf; Gen.map2 (fun a i -> Velocity (a, i)) axis leaf;
      Gen.map (fun i -> Speed2 i) leaf; Gen.map2 (fun i j -> Distance2 (i, j)) leaf leaf;
      Gen.map (fun a -> Momentum a) axis; Gen.map (fun a -> Angular a) axis;
      Gen.map2 (fun a i -> Spin (a, i)) axis leaf; Gen.map (fun i -> Spin2 i) leaf;
    ]

let num_atom =
  Gen.frequency
    [
      (1, Gen.map (fun k -> Const (Rat.of_int k)) (Gen.int_range 0 2));
      (9, Gen.map (fun q -> Quantity q) quantity);
    ]

let fact =
  Gen.oneof
    [
      Gen.map2 (fun i j -> Bound (i, j)) leaf leaf; Gen.map2 (fun i j -> Same (i, j)) leaf leaf;
      Gen.map2 (fun i j -> Touching (i, j)) leaf leaf; Gen.map2 (fun i k -> Behaviour (i, k)) leaf leaf;
      Gen.map3 (fun i p a -> Offers (i, p, a)) leaf
        (Gen.oneofl [ None; Some Behaviour.Name; Some Behaviour.Co_name ])
        name;
      Gen.return Quiescent; Gen.map (fun e -> Event e) event;
    ]

let prop_atom = Gen.frequency [ (1, Gen.map (fun b -> Bool b) Gen.bool); (7, Gen.map (fun f -> Fact f) fact) ]

let rec num n =
  if n <= 0 then num_atom
  else
    let sub = num (n / 2) in
    Gen.oneof
      [
        num_atom; Gen.map (fun a -> Neg a) sub; Gen.map2 (fun a b -> Add (a, b)) sub sub;
        Gen.map2 (fun a b -> Sub (a, b)) sub sub; Gen.map2 (fun a b -> Mul (a, b)) sub sub;
        Gen.map2 (fun a b -> Div (a, b)) sub sub; Gen.map (fun ps -> Count ps) (few (prop (n / 2)));
        Gen.map3 (fun p a b -> If (p, a, b)) (prop (n / 2)) sub sub;
      ]

and prop n =
  if n <= 0 then prop_atom
  else
    let sub = prop (n / 2) in
    Gen.oneof
      [
        prop_atom; Gen.map3 (fun c a b -> Compare (c, a, b)) comparison (num (n / 2)) (num (n / 2));
        Gen.map (fun p -> Not p) sub; Gen.map (fun ps -> And ps) (few sub);
        Gen.map (fun ps -> Or ps) (few sub);
      ]

let bound =
  Gen.oneofl
    [
      { low = Rat.zero; high = None }; { low = Rat.zero; high = Some Rat.one };
      { low = Rat.one; high = Some Rat.one };
    ]

let quantifier = Gen.oneofl [ All; Exists ]

let rec temporal n =
  if n <= 0 then Gen.map (fun p -> State p) prop_atom
  else
    let sub = temporal (n / 2) in
    Gen.oneof
      [
        Gen.map (fun p -> State p) (prop n); Gen.map (fun f -> Temporal_not f) sub;
        Gen.map (fun fs -> Temporal_and fs) (few sub); Gen.map (fun fs -> Temporal_or fs) (few sub);
        Gen.map2 (fun q f -> Next (q, f)) quantifier sub;
        Gen.map3 (fun q b f -> Finally (q, b, f)) quantifier bound sub;
        Gen.map3 (fun q b f -> Globally (q, b, f)) quantifier bound sub;
        Gen.map3 (fun (q, b) f g -> Until (q, b, f, g)) (Gen.pair quantifier bound) sub sub;
      ]

let formula = Gen.sized_size (Gen.int_range 0 16) temporal

(* {1 The same in another order} *)

let flip state = Random.State.bool state
let swap state (i, j) = if flip state then (j, i) else (i, j)
let shuffle state list =
  List.map (fun x -> (Random.State.bits state, x)) list
  |> List.stable_sort (fun (a, _) (b, _) -> Int.compare a b)
  |> List.map snd

let mirrored : Law.comparison -> Law.comparison = function
  | Lt -> Gt
  | Le -> Ge
  | Gt -> Lt
  | Ge -> Le
  | (Eq | Ne) as c -> c

let shuffled_ends s = function
  | (Any | One _) as e -> e
  | Two (i, j) ->
    let i, j = swap s (i, j) in
    Two (i, j)

let rec shuffled_num s = function
  | Quantity (Bonds (a, Some ends)) -> Quantity (Bonds (a, Some (swap s ends)))
  | Quantity (Distance2 (i, j)) ->
    let i, j = swap s (i, j) in
    Quantity (Distance2 (i, j))
  | Count ps -> Count (shuffle s (List.map (shuffled_prop s) ps))
  | Add (a, Add (b, c)) when flip s -> shuffled_num s (Add (Add (a, b), c))
  | Mul (Mul (a, b), c) when flip s -> shuffled_num s (Mul (a, Mul (b, c)))
  | Add (a, b) ->
    let a, b = swap s (shuffled_num s a, shuffled_num s b) in
    Add (a, b)
  | Mul (a, b) ->
    let a, b = swap s (shuffled_num s a, shuffled_num s b) in
    Mul (a, b)
  | Neg a -> Neg (shuffled_num s a)
  | Sub (a, b) -> Sub (shuffled_num s a, shuffled_num s b)
  | Div (a, b) -> Div (shuffled_num s a, shuffled_num s b)
  | If (p, a, b) -> If (shuffled_prop s p, shuffled_num s a, shuffled_num s b)
  | n -> n

and shuffled_prop s = function
  | Compare (c, a, b) ->
    let a = shuffled_num s a and b = shuffled_num s b in
    if flip s then Compare (mirrored c, b, a) else Compare (c, a, b)
  | Fact (Bound (i, j)) ->
    let i, j = swap s (i, j) in
    Fact (Bound (i, j))
  | Fact (Same (i, j)) ->
    let i, j = swap s (i, j) in
    Fact (Same (i, j))
  | Fact (Touching (i, j)) ->
    let i, j = swap s (i, j) in
    Fact (Touching (i, j))
  | Fact (Event (Bond (c, n, e))) -> Fact (Event (Bond (c, n, shuffled_ends s e)))
  | Fact (Event (Bounce e)) -> Fact (Event (Bounce (shuffled_ends s e)))
  | Not p -> Not (shuffled_prop s p)
  | And (p :: (_ :: _ as rest)) when flip s -> shuffled_prop s (And [ p; And rest ])
  | And ps -> And (shuffle s (List.map (shuffled_prop s) ps))
  | Or (p :: (_ :: _ as rest)) when flip s -> shuffled_prop s (Or [ Or rest; p ])
  | Or ps -> Or (shuffle s (List.map (shuffled_prop s) ps))
  | p -> p

let rec shuffled s = function
  | State p -> State (shuffled_prop s p)
  | Temporal_not f -> Temporal_not (shuffled s f)
  | Temporal_and fs -> Temporal_and (shuffle s (List.map (shuffled s) fs))
  | Temporal_or (f :: (_ :: _ as rest)) when flip s -> shuffled s (Temporal_or [ Temporal_or rest; f ])
  | Temporal_or fs -> Temporal_or (shuffle s (List.map (shuffled s) fs))
  | Next (q, f) -> Next (q, shuffled s f)
  | Finally (q, b, f) -> Finally (q, b, shuffled s f)
  | Globally (q, b, f) -> Globally (q, b, shuffled s f)
  | Until (q, b, f, g) -> Until (q, b, shuffled s f, shuffled s g)

(* {1 Laws} *)

let test ?(count = 1000) name gen law = QCheck2.Test.make ~count ~name gen law
let sign c = Int.compare c 0

(* The numbers of these formulas are machine integers, so that the order of the standard library tells
   whether two are the same. *)
let same (f : temporal) (g : temporal) = Stdlib.compare f g = 0

let equal_modulo_order f g = Formula.equal (Rename.ordered f) (Rename.ordered g)

let orders =
  [
    test "equal exactly when the same" (Gen.pair formula formula) (fun (f, g) ->
        Bool.equal (Formula.equal f g) (same f g));
    test "equal exactly when the same, for predicates" (Gen.pair (prop 1) (prop 1)) (fun (p, q) ->
        Bool.equal (Formula.equal_prop p q) (same (State p) (State q)));
    test "equal exactly when the same, for atoms" (Gen.pair num_atom num_atom) (fun (a, b) ->
        Bool.equal (Formula.equal_num a b) (Stdlib.compare a b = 0));
    test "equal exactly when the same, for events" (Gen.pair event event) (fun (e, f) ->
        Bool.equal (Formula.equal_event e f) (Stdlib.compare e f = 0));
    test "equal exactly when the same, but for leaves" (Gen.triple formula leaf leaf) (fun (f, i, j) ->
        let g = Rename.temporal (fun k -> if k = i then j else k) f in
        Bool.equal (Formula.equal f g) (same f g));
    test "antisymmetric" (Gen.pair formula formula) (fun (f, g) ->
        sign (Order.temporal f g) = -sign (Order.temporal g f));
    test "transitive" (Gen.triple formula formula formula) (fun (f, g, h) ->
        match List.sort Order.temporal [ f; g; h ] with
        | [ a; _; c ] -> Order.temporal a c <= 0
        | _ -> false);
    test "one form for all orders" (Gen.pair formula Gen.int) (fun (f, seed) ->
        equal_modulo_order f (shuffled (Random.State.make [| seed |]) f));
    test "the one form is its own" formula (fun f ->
        let g = Rename.ordered f in
        Formula.equal g (Rename.ordered g));
  ]

let transposition i j k = if k = i then j else if k = j then i else k

let renaming =
  [
    test "a transposition is its own inverse" formula (fun f ->
        let swap = Rename.temporal (transposition 0 2) in
        Formula.equal f (swap (swap f)));
    test "renamed leaves" formula (fun f ->
        let shift i = i + 10 in
        List.equal Int.equal
          (Formula.leaves (Rename.temporal shift f))
          (List.map shift (Formula.leaves f)));
    test "what is not renamed stays" formula (fun f ->
        let g = Rename.temporal (transposition 0 1) f in
        Bool.equal (Formula.global f) (Formula.global g)
        && Bool.equal (Formula.has_events f) (Formula.has_events g));
    test "exchangeable: as the whole in another order" (Gen.triple formula leaf leaf) (fun (f, i, j) ->
        let as_whole f = equal_modulo_order f (Rename.temporal (transposition i j) f) in
        let agrees f = Bool.equal (Exchangeable.are (Exchangeable.make f) i j) (as_whole f) in
        let other = Rename.temporal (transposition i j) f in
        agrees f && agrees (Temporal_or [ f; other ]) && agrees (Temporal_and [ other; other; f ]));
    test "nothing changes without the leaves" formula (fun f ->
        List.exists (fun i -> i < 2) (Formula.leaves f)
        || Formula.equal f (Rename.temporal (transposition 0 1) f));
  ]

(* {1 Cases} *)

let always p = Globally (All, { low = Rat.zero; high = None }, State p)
let positive n = Compare (Gt, n, Const Rat.zero)

let size i = Quantity (Size i)
let distance2 i j = Quantity (Distance2 (i, j))
let bound i j = Fact (Bound (i, j))
let happens e = Fact (Event e)

let symmetric name f expected =
  Alcotest.test_case name `Quick (fun () ->
      Alcotest.(check bool) name expected
        (equal_modulo_order f (Rename.temporal (transposition 0 1) f));
      Alcotest.(check bool) "by parts" expected (Exchangeable.are (Exchangeable.make f) 0 1))

let symmetries =
  [
    symmetric "distance" (always (positive (distance2 0 1))) true;
    symmetric "a sum" (always (positive (Add (Add (size 2, size 0), size 1)))) true;
    symmetric "a difference" (always (positive (Sub (size 0, size 1)))) false;
    symmetric "an equation" (always (Compare (Eq, size 0, size 1))) true;
    symmetric "an inequation" (always (Compare (Le, size 0, size 1))) false;
    symmetric "both ways" (always (Or [ Compare (Lt, size 0, size 1); Compare (Gt, size 0, size 1) ])) true;
    symmetric "brackets"
      (always (And [ And [ bound 2 0; Fact Quiescent ]; bound 1 2 ])) true;
    symmetric "one of two" (always (bound 0 2)) false;
    symmetric "twice and once" (always (And [ bound 0 2; bound 0 2; bound 1 2 ])) false;
    symmetric "an event" (always (happens (Bounce (Two (0, 1))))) true;
    symmetric "events of each" (always (Or [ happens (Bounce (One 0)); happens (Bounce (One 1)) ])) true;
    symmetric "events of one" (always (happens (Bond (Made, None, Two (0, 2))))) false;
    symmetric "a behaviour" (always (Fact (Behaviour (0, 0)))) false;
  ]

let looks () =
  let leaves f = Formula.leaves f and ints = Alcotest.(list int) in
  Alcotest.check ints "sorted, each once" [ 0; 1; 2 ]
    (leaves (always (And [ bound 2 1; happens (Bounce (One 0)); positive (distance2 1 2) ])));
  Alcotest.check ints "of numbers of predicates" [ 1; 4 ]
    (leaves (always (positive (Count [ Fact (Same (4, 1)); positive (If (Bool true, size 1, Quantity Time)) ]))));
  let global name p expected = Alcotest.(check bool) name expected (Formula.global (always p)) in
  global "all bonds" (positive (Quantity (Bonds (Some "a", None)))) true;
  global "bonds of two" (positive (Quantity (Bonds (Some "a", Some (0, 1))))) false;
  global "deep inside" (Not (positive (Neg (Count [ Or [ Fact Quiescent ] ])))) true;
  global "an event without leaves" (happens (Bond (Made, Some "a", Any))) true;
  global "an event of a leaf" (happens (Bond (Made, Some "a", One 0))) false;
  global "time" (positive (Quantity Time)) false;
  Alcotest.(check bool) "events" true (Formula.has_events (always (positive (Count [ happens (Bounce Any) ]))))

(* Three cubes, of a part each. *)
let model =
  let cube i = Printf.sprintf "process c[%d] = solids.Cube(1) mass 1 at translate (%d,0,0) [nil]\n" i (4 * i) in
  let text = "import <solids>\n" ^ String.concat "" (List.init 3 cube) in
  match Scc_test_models.Load.text text with
  | Ok e -> e.model
  | Error _ -> failwith "the model is refused"

let sees () =
  let time_seen name p expected =
    let same =
      match (Time_seen.formula model (always p), expected) with
      | Time_seen.Until c, Time_seen.Until d -> Scc_exact.Rat.equal c d
      | a, b -> Time_seen.same_kind a b
    in
    Alcotest.(check bool) name true same
  in
  let time = Quantity Time in
  let number n = Property.Const (Scc_exact.Rat.of_int n) in
  let compare a b = Property.Compare (Lt, a, b) in
  let until n = Time_seen.Until (Scc_exact.Rat.of_int n) in
  time_seen "nothing" (positive (size 0)) Never;
  time_seen "a constant" (compare time (number 3)) (until 3);
  time_seen "on the other side" (compare (number 3) time) (until 3);
  time_seen "before the start" (compare time (number (-3))) (until 0);
  time_seen "the greatest" (And [ compare time (number 3); Not (compare time (number 7)); Fact Quiescent ])
    (until 7);
  time_seen "a multiple" (compare (Mul (number 2, time)) (Sub (number 9, time))) (until 3);
  time_seen "a share" (compare (Neg (Div (time, number 2))) (Add (number (-4), number 1))) (until 6);
  time_seen "time less itself" (compare (Sub (time, time)) (number 3)) Never;
  time_seen "a square" (compare (Mul (time, time)) (number 3)) Always;
  time_seen "a divisor" (compare (Div (number 1, time)) (number 3)) Always;
  time_seen "a divisor of zero" (compare (Div (time, number 0)) (number 3)) Always;
  time_seen "with what changes" (compare time (Quantity (Position (X, 0)))) Always;
  time_seen "conditions" (positive (Count [ compare time (number 3); Fact Quiescent ])) (until 3);
  time_seen "of values" (positive (If (compare time (number 3), size 0, size 1))) (until 3);
  time_seen "values by conditions" (compare (If (Fact Quiescent, time, size 1)) (number 3)) (until 3);
  time_seen "one of several constants" (compare time (If (Fact Quiescent, number 3, number 8))) (until 8);
  time_seen "a condition in it" (compare time (If (compare time (number 9), number 3, number 8))) (until 9);
  time_seen "a place, or a constant"
    (compare time (If (Fact Quiescent, Quantity (Position (X, 0)), number 8)))
    Always;
  time_seen "twice how many there are" (compare time (Mul (number 2, Quantity Processes))) (until 6);
  time_seen "of a leaf" (compare (Sub (size 0, number 7)) (Neg time)) (until 7);
  time_seen "how many bonds" (compare (Add (number 1, Quantity (Bonds (None, None)))) time) (until 4);
  time_seen "a count"
    (compare (Mul (number 3, time)) (Count [ Fact Quiescent; Bool true ]))
    (Until (Rat.make (Z.of_int 2) (Z.of_int 3)));
  let squared = always (positive (Mul (time, time))) in
  let until = Until (All, { low = Scc_exact.Rat.zero; high = None }, State (Fact Quiescent), squared) in
  Alcotest.(check bool) "under operators" true (Time_seen.same_kind Always (Time_seen.formula model until));
  let mean n : Property.check =
    let at = { low = Rat.one; high = Some Rat.one } in
    let formula = Finally (All, at, State (Compare (Ge, n, number 0))) in
    let asked = Expected ([ Least ], Value_at (n, Rat.one), None) in
    { name = "c"; span = Scc_base.Span.none; text = ""; asked; formula }
  in
  let means n = Time_seen.checks model [ mean n ] in
  Alcotest.(check bool) "a mean of time" true (Time_seen.same_kind Always (means time));
  Alcotest.(check bool) "and of none" true (Time_seen.same_kind Never (means (size 0)))

let steers () =
  let law name text expected =
    let text =
      "import <solids>\nprocess p = solids.Cube(1) mass 1 velocity (1,0,0) [nil]\nmotion p = " ^ text ^ "\n"
    in
    let seen =
      match Scc_test_models.Load.text text with
      | Ok e -> Time_seen.law e.model e.model.leaves.(0).law
      | Error _ -> Alcotest.failf "a law is refused: %s" text
    in
    let same =
      match (seen, expected) with
      | Time_seen.Until c, Time_seen.Until d -> Rat.equal c d
      | a, b -> Time_seen.same_kind a b
    in
    Alcotest.(check bool) name true same
  in
  let until n = Time_seen.Until (Rat.of_int n) in
  law "no time" "(vx, x, 0)" Never;
  law "itself" "(time, 0, 0)" Always;
  law "a switch" "(if time < 5 then 1 else -1, 0, 0)" (until 5);
  law "several" "(if 2 * time > 5 and not time > 8 then vx else -1, if 7 < time then 0 else 1, 0)" (until 8);
  law "a rounded time" "(if round(time, 2) < 5 then 1 else -1, 0, 0)" Always;
  law "with a place" "(if time < x then 1 else -1, 0, 0)" Always;
  law "a weight" "choose { (1,0,0) weight if time < 3 then 1 else 2, (0,0,0) }" (until 3);
  law "a weight that grows" "choose { (1,0,0) weight time, (0,0,0) weight 1 }" Always

let () =
  let cases = Scc_test_support.Property.cases in
  Alcotest.run "formulas"
    [
      ("orders", cases orders);
      ("renaming", cases renaming);
      ("symmetries", symmetries);
      ( "looks",
        [
          Alcotest.test_case "what formulas look at" `Quick looks;
          Alcotest.test_case "how much of time formulas see" `Quick sees;
          Alcotest.test_case "how much of time laws see" `Quick steers;
        ] );
    ]
