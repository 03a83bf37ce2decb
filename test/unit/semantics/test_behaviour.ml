(* Section 2 of the rule book: behaviours. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Fixture
module Gen = QCheck2.Gen

let defs : Behaviour.definitions =
  [|
    { name = "Plain"; body = open_ "a" [ "top" ] (Behaviour.call 0) };
    { name = "Slow"; body = eps (q 2) (weak "a" [ "top" ] (Behaviour.call 0)) };
    { name = "Chain"; body = eps (ratio 1 2) (Behaviour.call 1) };
    { name = "Mixed"; body = eps (q 1) (Behaviour.call 2) + Behaviour.call 0 };
    { name = "Loop"; body = eps (ratio 3 4) (Behaviour.call 4) };
    { name = "Twice"; body = eps (q 1) (Behaviour.call 5 + Behaviour.call 5) };
    { name = "Padded"; body = eps (q 1) (Behaviour.call 6) + nil };
    { name = "Left"; body = Behaviour.call 0 + eps (q 3) nil };
    { name = "Later"; body = eps (q 2) (Behaviour.call 1) + eps (q 1) nil };
    { name = "Alias"; body = Behaviour.call 2 };
  |]

let gen_time = Gen.map2 ratio (Gen.int_range 0 24) (Gen.int_range 1 8)

let gen_behaviour =
  let leaf =
    Gen.oneof [ Gen.pure nil; Gen.map Behaviour.call (Gen.int_range 0 (Stdlib.( - ) (Array.length defs) 1)) ]
  in
  Gen.sized_size (Gen.int_range 0 12)
    (Gen.fix (fun self n ->
         if n = 0 then leaf
         else
           let below = self (n / 2) in
           Gen.oneof
             [
               leaf;
               Gen.map2 eps gen_time below;
               Gen.map2 Behaviour.sum below below;
               Gen.map (open_ "a" [ "top"; "left" ]) below;
               Gen.map (co_open "b" [ "top" ]) below;
               Gen.map (weak "a" [ "right" ]) below;
               Gen.map (strong [ ("a", [ "top" ]); ("b", [ "left" ]) ]) below;
             ]))

let equal = Behaviour.equal_aged

let additivity =
  QCheck2.Test.make ~name:"TimeBehaviour: time is additive" ~count:1000
    (Gen.triple gen_behaviour gen_time gen_time) (fun (b, d, e) ->
        let b = Behaviour.fresh b in
        equal (Behaviours.pass defs (Rat.add d e) b) (Behaviours.pass defs e (Behaviours.pass defs d b)))

let before_horizon =
  QCheck2.Test.make ~name:"TimeBehaviour: the horizon shrinks by what has passed, and offers stay till then"
    ~count:1000
    (Gen.triple gen_behaviour (Gen.int_range 1 7) Gen.unit)
    (fun (b, k, ()) ->
       let b = Behaviour.fresh b in
       match Behaviours.horizon defs b with
       | None -> equal (Behaviours.pass defs (q k) b) b
       | Some h ->
         let d = Rat.mul h (ratio k 8) in
         let later = Behaviours.pass defs d b in
         let strip (o, _) = o in
         Option.equal Rat.equal (Behaviours.horizon defs later) (Some (Rat.sub h d))
         && List.length (Behaviours.derivations defs b)
            = List.length (List.map strip (Behaviours.derivations defs later)))

let order =
  QCheck2.Test.make ~name:"canonical terms: compare is an order that hash respects" ~count:1000
    (Gen.triple gen_behaviour gen_behaviour gen_behaviour) (fun (a, b, c) ->
        let sign x = Int.compare x 0 in
        sign (Behaviour.compare a b) = Stdlib.( ~- ) (sign (Behaviour.compare b a))
        && ((not (Behaviour.compare a b <= 0 && Behaviour.compare b c <= 0)) || Behaviour.compare a c <= 0)
        && ((not (Behaviour.equal a b)) || Behaviour.hash a = Behaviour.hash b)
        && Behaviour.equal a a)

let offered b =
  List.map
    (fun (offer, (d : Behaviours.derivation)) ->
       let via = (if d.by_sum then "+" else "") ^ if d.by_def then "K" else "" in
       match offer with
       | Behaviours.Offer_open (Name, c, _) -> "<" ^ c.name ^ ">" ^ via
       | Offer_open (Co_name, c, _) -> "<~" ^ c.name ^ ">" ^ via
       | Offer_weak (c, _, _) -> "omega " ^ c.name ^ via
       | Offer_strong (l, _, _) -> "rho" ^ string_of_int (List.length l) ^ via)
    (Behaviours.derivations defs (Behaviour.fresh b))

let check_offers name b expected () = Alcotest.(check (list string)) name expected (offered b)

let rules =
  let t = [ "top" ] in
  [
    ("Pre: a prefix offers its channel", open_ "a" t nil, [ "<a>" ]);
    ("Pre: a co-name is offered as such", co_open "a" t nil, [ "<~a>" ]);
    ("Weak: omega offers the release", weak "a" t nil, [ "omega a" ]);
    ("Strong: rho offers the reaction", strong [ ("a", t); ("b", t) ] nil, [ "rho2" ]);
    ("Sum: both summands offer, in order", open_ "a" t nil + weak "b" t nil, [ "<a>+"; "omega b+" ]);
    ("Sum: equal summands offer once", open_ "a" t nil + open_ "a" t nil, [ "<a>+" ]);
    ("Def: a name offers what its body does", Behaviour.call 0, [ "<a>K" ]);
    ("Eps0: eps(0).B is B", eps (q 0) (open_ "a" t nil), [ "<a>" ]);
    ("TimeBehaviour: an exposed eps offers nothing", eps (q 1) (open_ "a" t nil), []);
  ]
  |> List.map (fun (name, b, expected) -> Alcotest.test_case name `Quick (check_offers name b expected))

let origin () =
  let after d k = (Behaviours.pass defs d (Behaviour.fresh (Behaviour.call k))).origin in
  let check what expected got = Alcotest.(check (option int)) what expected got in
  check "a name is its own origin" (Some 2) (after (q 0) 2);
  check "ageing keeps the origin" (Some 2) (after (ratio 1 4) 2);
  check "a name that an eps brings up takes over" (Some 1) (after (ratio 1 2) 2);
  check "also when it is passed" (Some 1) (after (q 2) 2);
  check "a name that is left alone of a sum does not count" (Some 7) (after (q 3) 7);
  check "nor one that comes up in a sum" (Some 8) (after (q 2) 8);
  check "nor what comes up after it" (Some 8) (after (q 4) 8);
  check "a name for a name is as what it stands for" (Some 1) (after (q 1) 9);
  check "the whole of what a sum becomes counts" (Some 2)
    (Behaviours.pass defs (q 1) (Behaviour.fresh (eps (q 1) (Behaviour.call 2)))).origin;
  let folded = Behaviours.pass defs (q 5) (Behaviour.fresh (Behaviour.call 0)) in
  Alcotest.(check bool) "without exposed eps a name stays folded" true
    (equal folded (Behaviour.fresh (Behaviour.call 0)))

let brackets () =
  let x = open_ "a" [ "top" ] nil and y = weak "a" [ "top" ] nil and z = eps (q 1) nil in
  Alcotest.(check bool) "sums have no brackets" true
    (Behaviour.equal (x + (y + (z + nil))) (x + y + (z + nil))
     && Behaviour.equal ((x + y) + z + nil) (x + (y + z) + nil));
  Alcotest.(check bool) "but an order" false (Behaviour.equal (x + y) (y + x))

let recurrence () =
  let after d k = Behaviours.pass defs (q d) (Behaviour.fresh (Behaviour.call k)) in
  Alcotest.(check bool) "equal summands" true (equal (after 2 5) (after 4 5));
  Alcotest.(check bool) "nil" true (equal (after 1 6) (after 2 6));
  let entry = ("a", [ "top" ]) in
  Alcotest.(check bool) "an entry written twice" true
    (Behaviour.equal (strong [ entry; entry ] nil) (strong [ entry ] nil))

let unguarded () =
  let call = Behaviour.call in
  let body body : Behaviour.definition = { name = "K"; body } in
  let defs =
    [|
      body (call 1 + nil); body (call 0); body (open_ "a" [ "top" ] (call 2)); body (eps (q 1) (call 3));
      body (call 0); body (eps (q 0) (call 5));
    |]
  in
  Alcotest.(check (list int)) "the definitions on unguarded cycles" [ 0; 1; 5 ]
    (Behaviour.unguarded ~may_be_zero:(fun _ -> false) defs)

(* Two ways from each definition to the next: as many ways as 2 to their number. *)
let prefixes () =
  let count = 40 in
  let chain last : Behaviour.definitions =
    Array.init count (fun k : Behaviour.definition ->
        let next = if k = Stdlib.( - ) count 1 then last else Behaviour.call (succ k) in
        { name = Printf.sprintf "K%d" k; body = eps (ratio 1 7) next + eps (ratio 1 5) next })
  in
  let looked = ref 0 in
  let find defs behind what =
    looked := 0;
    let is b = incr looked; what b in
    Behaviour.some_prefix defs ~behind is (Behaviour.call 0)
  in
  let is_open : Behaviour.t -> bool = function Open _ -> true | _ -> false in
  let check what expected got = Alcotest.(check bool) what expected got in
  let x = open_ "a" [ "top" ] nil and round = Behaviour.call 0 in
  check "what is last is found" true (find (chain x) Behaviour.is_delay is_open);
  check "and nothing where there is nothing" false (find (chain round) Behaviour.is_delay is_open);
  Alcotest.(check int) "each definition is looked at once" (2 * count) !looked;
  check "only where one looks" false (find (chain x) (fun _ -> false) is_open);
  check "nor behind what is no delay" false
    (find (chain (weak "a" [ "top" ] x)) Behaviour.is_delay is_open);
  check "but where one looks behind all" true (find (chain (weak "a" [ "top" ] x)) (fun _ -> true) is_open)

let suite =
  ("behaviour",
   [
     ("rules", rules);
     ( "terms",
       [
         Alcotest.test_case "I-14: the origin of a behaviour follows the passing of time" `Quick origin;
         Alcotest.test_case "I-17: aged sums recur, and L is a set" `Quick recurrence;
         Alcotest.test_case "State: terms are as they are written" `Quick brackets;
         Alcotest.test_case "guardedness" `Quick unguarded;
         Alcotest.test_case "Prefixes: each definition is looked at once" `Quick prefixes;
       ] );
     ("laws", Scc_test_support.Property.cases [ additivity; before_horizon; order ]);
   ])
