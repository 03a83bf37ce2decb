(* Means of numbers: their intervals where a range is known, by whole distributions and by counting; and that
   there is none where it is not known. *)

open Scc_exact
open Scc_runs
open Scc_estimate
open Scc_test_support
open Scc_test_models
open Counting

(* {1 Intervals} *)

let range low high ~ends_only = { Range.low = Some low; high = Some high; ends_only }

(* Both ends, where there is one look. *)
let interval tally range ~miss =
  match Tally.mean tally range ~look:miss ~miss with
  | Some low, Some high -> (low, high)
  | _ -> Alcotest.fail "an end is missing"

(* A number that is 0, 1 or 2 with chances that are given: all ways in which so many runs may come out. *)
let three_valued n chances =
  let factorial = Array.make (n + 1) Z.one in
  for i = 1 to n do
    factorial.(i) <- Z.mul factorial.(i - 1) (Z.of_int i)
  done;
  let ways a b =
    let c = n - a - b in
    let count = Z.div factorial.(n) (Z.mul factorial.(a) (Z.mul factorial.(b) factorial.(c))) in
    let p, q, r = chances in
    ((a, b, c), Rat.mul (Rat.make count Z.one) (Rat.mul (power p a) (Rat.mul (power q b) (power r c))))
  in
  List.concat (List.init (n + 1) (fun a -> List.init (n - a + 1) (ways a)))

let tally_of (zeros, ones, twos) =
  let number x _ = Sample.Number (Rat.of_int x) in
  let add count x tally = List.fold_left Tally.add tally (List.init count (number x)) in
  add zeros 0 (add ones 1 (add twos 2 Tally.empty))

let missed_by mean (low, high) = Rat.compare mean low < 0 || Rat.compare mean high > 0

let mean_covers =
  QCheck2.Test.make ~name:"coverage of means, by the whole distribution" ~count:30
    ~print:(fun (n, (a, b, c)) -> Printf.sprintf "n = %d, chances as %d : %d : %d" n a b c)
    QCheck2.Gen.(pair (int_range 1 12) (triple (int_range 0 50) (int_range 0 9) (int_range 1 9)))
    (fun (n, (a, b, c)) ->
       let chance x = fraction x (a + b + c) in
       let mean = fraction (b + (2 * c)) (a + b + c) and miss = fraction 1 5 in
       let add sum (counts, likely) =
         let found = interval (tally_of counts) (range Rat.zero (Rat.of_int 2) ~ends_only:false) ~miss in
         if missed_by mean found then Rat.add sum likely else sum
       in
       let missed = List.fold_left add Rat.zero (three_valued n (chance a, chance b, chance c)) in
       Rat.compare missed miss <= 0)

(* Where it is one of two numbers, the mean is a probability, and so is its interval. *)
let mean_of_two =
  QCheck2.Test.make ~name:"the mean of one of two numbers is as a probability" ~count:50 ~print small
    (fun (n, k, m) ->
       let miss = fraction m 1000 in
       let of_outcomes make = List.fold_left Tally.add Tally.empty (List.init n (fun i -> make (i < k))) in
       let low, high = Tally.likelihood (of_outcomes (fun yes -> Sample.Truth yes)) ~miss in
       let at p = Rat.add (Rat.of_int (-3)) (Rat.mul (fraction 7 2) p) in
       let number yes = Sample.Number (if yes then fraction 1 2 else Rat.of_int (-3)) in
       let below, above =
         interval (of_outcomes number) (range (Rat.of_int (-3)) (fraction 1 2) ~ends_only:true) ~miss
       in
       Rat.equal below (at low) && Rat.equal above (at high))

(* Whatever those that are open come to, the interval has that of the numbers when they are known. *)
let mean_of_open =
  QCheck2.Test.make ~name:"runs that are open may come to anything in the range" ~count:50
    ~print:QCheck2.Print.(list (pair int bool))
    QCheck2.Gen.(list_size (int_range 1 40) (pair (int_bound 6) bool))
    (fun runs ->
       let tally make = List.fold_left Tally.add Tally.empty (List.map make runs) in
       let range = range Rat.zero (Rat.of_int 6) ~ends_only:false and miss = fraction 1 10 in
       let low, high = interval (tally (fun (x, _) -> Sample.Number (Rat.of_int x))) range ~miss in
       let below, above =
         let known (x, open_) = if open_ then Sample.Too_long Steps else Number (Rat.of_int x) in
         interval (tally known) range ~miss
       in
       Rat.compare below low <= 0 && Rat.compare above high >= 0)

(* {1 Ranges} *)

let two_bodies =
  "model m\nimport <solids>\nprocess a = solids.Cube(1) mass 1 [nil]\n\
   process b = solids.Cube(1) mass 1 at translate (9, 0, 0) [nil]\n"

let two = (Load.exactly (Load.text two_bodies)).model

(* What the atoms are is drawn first, and then numbers with their values. *)
let numbers =
  let open QCheck2.Gen in
  let rational = map (fun (n, d) -> fraction n d) (pair (int_range (-6) 6) (int_range 1 3)) in
  let truth = map (fun b -> (Scc_property.Property.Bool b, b)) bool in
  let* bonds = int_bound 1 and* size = int_range 1 2 and* speed2 = map Rat.abs rational and* momentum = rational in
  let leaf =
    oneof
      [
        map (fun r -> (Scc_property.Property.Const r, r)) rational;
        map
          (fun truths ->
             let holding = List.length (List.filter snd truths) in
             (Scc_property.Property.Count (List.map fst truths), Rat.of_int holding))
          (list_size (int_bound 3) truth);
        return (Scc_property.Property.Quantity (Bonds (None, Some (0, 1))), Rat.of_int bonds);
        return (Scc_property.Property.Quantity (Bonds (None, None)), Rat.of_int bonds);
        return (Scc_property.Property.Quantity (Size 0), Rat.of_int size);
        return (Scc_property.Property.Quantity Processes, Rat.of_int size);
        return (Scc_property.Property.Quantity (Speed2 0), speed2);
        return (Scc_property.Property.Quantity (Momentum X), momentum);
        return (Scc_property.Property.Quantity Time, fraction 5 2);
      ]
  in
  let both make value = fun (n, x) (m, y) -> (make n m, value x y) in
  let quotient (n, x) (m, y) =
    if Rat.sign y = 0 then (n, x) else (Scc_property.Property.Div (n, m), Rat.div x y)
  in
  (* A choice between two by a comparison of them, as [min] and [max] are, or of others. *)
  let chosen (n, x) (m, y) (relation, swapped) =
    let given = Scc_property.Property.Compare (relation, n, m) in
    let holds = Scc_calculus.Law.compare_rationals relation x y in
    let (n, x), (m, y) = if swapped then ((m, y), (n, x)) else ((n, x), (m, y)) in
    (Scc_property.Property.If (given, n, m), if holds then x else y)
  in
  let relations = pair (oneofl Scc_calculus.Law.[ Lt; Le; Gt; Ge; Eq; Ne ]) bool in
  let node self size =
    let half = self (size / 2) in
    oneof
      [
        map3 chosen half half relations;
        map (fun (n, x) -> (Scc_property.Property.Neg n, Rat.neg x)) half;
        map2 (both (fun n m -> Scc_property.Property.Add (n, m)) Rat.add) half half;
        map2 (both (fun n m -> Scc_property.Property.Sub (n, m)) Rat.sub) half half;
        map2 (both (fun n m -> Scc_property.Property.Mul (n, m)) Rat.mul) half half;
        map2 quotient half half;
        map3
          (fun (p, b) (n, x) (m, y) -> (Scc_property.Property.If (p, n, m), if b then x else y))
          truth half half;
      ]
  in
  sized_size (int_bound 12) (fix (fun self size -> if size = 0 then leaf else oneof [ leaf; node self size ]))

let in_ranges =
  QCheck2.Test.make ~name:"numbers are in their ranges" ~count:1500
    ~print:(fun (n, x) -> Scc_property.Show.num two n ^ " = " ^ Rat.to_string x)
    numbers
    (fun (n, x) ->
       let r = Range.of_number two ~from:None ~time:(fraction 5 2) n in
       let is end_ = Option.equal Rat.equal end_ (Some x) in
       Option.fold ~none:true ~some:(fun low -> Rat.compare low x <= 0) r.low
       && Option.fold ~none:true ~some:(fun high -> Rat.compare x high <= 0) r.high
       && ((not r.ends_only) || is r.low || is r.high))

(* What runs come to is in the ranges of motion, where these are known. *)
let in_motion (file, given, time, numbers) =
  let overrides = List.map (fun (name, x) -> (name, Rat.of_int x)) given in
  let one number =
    let check = Printf.sprintf "\ncheck asked : E = ? [ %s at %s ]\n" number time in
    let e = Load.exactly (Load.text ~overrides (Load.read ("../../../specs/models/" ^ file) ^ check)) in
    let check = List.find (fun (c : Scc_property.Property.check) -> c.name = "asked") e.checks in
    let path = Result.get_ok (Path.of_check ~from:e.declared e.model check) in
    let semantics = Scc_engine.Standard.of_model e.model in
    let plan =
      { Sample.semantics; declared = e.declared; paths = [ path ]; free = Evenly; steps = None; until = None }
    in
    let low, high =
      match path.question with
      | Amounts (_, { low = Some low; high = Some high; _ }) -> (low, high)
      | Amounts _ | Does -> Alcotest.failf "%s: %s has no range" file number
    in
    for i = 0 to 19 do
      match (Sample.run plan ~seed:5L ~interrupted:(fun () -> false) i).outcomes with
      | [ Number x ] when missed_by x (low, high) ->
        Alcotest.failf "%s: %s is %s, not in [%s, %s]" file number (Rat.to_string x) (Rat.to_string low)
          (Rat.to_string high)
      | _ -> ()
    done
  in
  List.iter one numbers

let moving =
  [
    ("ruin.sc", [], "3", [ "x(walker)"; "vx(walker)"; "speed2(walker)"; "energy"; "momentum.x" ]);
    ("brownian.sc", [], "6", [ "x(ligand)"; "energy"; "distance2(ligand, pocket)" ]);
    ("crowds/pore.sc", [ ("n", 4) ], "9", [ "x(p[1])"; "distance2(p[1], p[2])"; "energy"; "momentum.y" ]);
    ("crowds/filament.sc", [ ("n", 4) ], "30", [ "x(m[1])"; "speed2(m[2])" ]);
  ]

(* {1 Estimates} *)

(* Of numbers that may be anything there is no interval, and nothing is decided: neither from a sample without
   variance nor from one of much, whatever its size. *)
let without_range () =
  let one property numbers size =
    let width = Rat.of_int 1000 in
    let aim = { Estimation.confidence = fraction 1 2; width; size; free = Sample.Apart; normal = false } in
    let t = Estimation.start aim [ path property ] in
    let rec go made =
      match Estimation.next t with
      | None -> List.hd (Estimation.answers t)
      | Some n ->
        for i = made to n - 1 do
          Estimation.add t { Sample.outcomes = [ Number (numbers i) ]; chosen = false; interrupted = false }
        done;
        Estimation.judge t ~last:false;
        go n
    in
    let a = go 0 in
    let verdict = if String.length property > 4 && property.[2] = '=' then Estimation.Sampled else Undecided in
    Alcotest.(check bool) (property ^ ": undecided, and why") true
      (a.verdict = verdict && a.reasons <> []
       && match a.value with Sample _ -> true | _ -> false)
  in
  List.iter
    (fun property ->
       List.iter
         (fun numbers ->
            List.iter (one property numbers) [ Exactly 1; Exactly 2; Exactly 5_000; At_most 10; At_most 3_000 ])
         [
           (fun _ -> Rat.zero);
           (fun _ -> fraction 7 3);
           (fun i -> if i mod 1000 = 999 then Rat.of_int 1000 else Rat.zero);
           (fun i -> Rat.of_int (i mod 2));
         ])
    [
      "E = ? [ x(a) at 1 ]"; "E <= 1/2 [ x(a) at 1 ]"; "E < 5 [ count(i in 1..1: x(a) > 0) / vx(a) at 1 ]";
      "E > 5 [ 1 / count(i in 1..1: x(a) > 0) at 1 ]";
      "E = ? [ if x(a) > 0 then energy * vx(a) else 0 at 1 ]"; "E < 0 [ momentum.x at 1 ]";
    ]

(* With one end the mean is known from there, and a comparison only where it is beyond the other side. *)
let with_one_end () =
  let verdict property numbers =
    let confidence = fraction 99 100 and size = Estimation.Exactly 400 in
    let aim = { Estimation.confidence; width = fraction 1 2; size; free = Apart; normal = false } in
    let t = Estimation.start aim [ path property ] in
    for i = 0 to 399 do
      Estimation.add t { Sample.outcomes = [ numbers i ]; chosen = false; interrupted = false }
    done;
    Estimation.judge t ~last:false;
    List.hd (Estimation.answers t)
  in
  let times i = Sample.Number (Rat.of_int (i mod 9)) in
  let check what property numbers expected =
    Alcotest.(check bool) what true ((verdict property numbers).verdict = expected)
  in
  check "more" "E >= 3 [ time U x(a) >= 3 ]" times Estimation.Holds;
  check "not less" "E < 3 [ time U x(a) >= 3 ]" times Violated;
  check "perhaps more" "E <= 100 [ time U x(a) >= 3 ]" times Undecided;
  check "not known to be as much" "E >= 4 [ time U x(a) >= 3 ]" times Undecided;
  check "events" "E >= 3 [ event bounce U x(a) >= 3 ]" times Holds;
  check "from above" "E <= -3 [ 1 - energy - distance2(a, a) at 1 ]"
    (fun i -> Sample.Number (Rat.of_int (-(i mod 9))))
    Holds;
  let some_open i = if i mod 4 = 0 then Sample.Too_long Steps else times i in
  check "some are open" "E >= 2 [ time U x(a) >= 3 ]" some_open Holds;
  let a = verdict "E = ? [ time U x(a) >= 3 ]" times in
  Alcotest.(check bool) "and no other end" true
    (a.reasons <> [] && match a.value with Mean { low = Some _; high = None; _ } -> true | _ -> false)

(* Means of numbers that are in a range: how often the interval misses. *)
let means ~count size () =
  let miss = fraction 1 20 in
  let confidence = Rat.sub Rat.one miss in
  let aim = { Estimation.confidence; width = fraction 1 3; size; free = Sample.Apart; normal = false } in
  let path = path "E = ? [ count(i in 1..4: x(a) > i) at 1 ]" in
  (* 4 with 1/20, else 0: a rare number at an end *)
  let mean = fraction 1 5 in
  let rec go i g wrong =
    if i = count then wrong
    else
      let t = Estimation.start aim [ path ] in
      let rec throw n g =
        if n = 0 then g
        else
          let side, g = coin (fraction 1 20) g in
          let outcomes = [ Sample.Number (Rat.of_int (if side then 4 else 0)) ] in
          Estimation.add t { outcomes; chosen = false; interrupted = false };
          throw (n - 1) g
      in
      let rec looks made g =
        match Estimation.next t with
        | None -> g
        | Some n ->
          let g = throw (n - made) g in
          Estimation.judge t ~last:false;
          looks n g
      in
      let g = looks 0 g in
      match (List.hd (Estimation.answers t)).value with
      | Mean { low = Some low; high = Some high; _ } ->
        go (i + 1) g (if missed_by mean (low, high) then wrong + 1 else wrong)
      | _ -> Alcotest.fail "no mean"
  in
  few_missed "means" ~count ~miss (go 0 (Splitmix64.of_seed 11L) 0)

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "means"
    [
      ("intervals", Property.cases [ mean_covers; mean_of_two; mean_of_open ]);
      ( "ranges",
        Property.cases [ in_ranges ]
        @ [
          case "Ranges: bodies are no faster, and no farther" (fun () -> List.iter in_motion moving);
        ] );
      ( "estimates",
        [
          case "without range" without_range;
          case "Betting: with one end" with_one_end;
          case "1000 means of 60 numbers" (means ~count:1_000 (Exactly 60));
          case "200 means in looks" (means ~count:200 (At_most 1_000));
        ] );
    ]
