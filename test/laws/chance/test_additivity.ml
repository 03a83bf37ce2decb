(* Law Additivity: how often something happens in parts that never meet is what it is in each, summed up; also
   where it happens in several at one instant, by one transition. *)

open Scc_exact
open Scc_semantics
open Scc_verify
open Scc_test_models
module Gen = QCheck2.Gen

(* The least number and the greatest, where they are known. *)
let answer (o : Verdict.outcome) =
  match o.verdict with
  | Measured { values; reasons = []; _ } -> (
      let value (_, (v : Scc_ctl.Eval.measured)) =
        match (v.least, v.most) with Exact x, Exact y when Rat.equal x y -> Some x | _ -> None
      in
      match List.map value values with [ Some least; Some greatest ] -> Some (least, greatest) | _ -> None)
  | _ -> None

let answers text =
  let e = Load.exactly (Load.text text) in
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> failwith "no initial state"
  | Ok initial ->
    let bounds = { Bounds.default with states = Default 4000 } in
    List.map answer (Check.run { Setup.default with bounds } semantics ~initial e.checks).outcomes

(* {1 The law} *)

type case = { clusters : Told_otherwise.cluster list; timestep : string; events : string list; until : string }

(* Some clusters alone, as they are called and placed in the whole: the others are left out. *)
let text c ~kept events =
  let told k cluster =
    if kept k then cluster else { Told_otherwise.leaves = []; bonds = []; wall = None }
  in
  let model = { Told_otherwise.clusters = List.mapi told c.clusters; timestep = c.timestep; questions = [] } in
  let check i e = Printf.sprintf "check c%d : E = ? [ %s U time > %s ]" i e c.until in
  String.concat "\n" (Told_otherwise.to_text Told_otherwise.as_it_is model :: List.mapi check events) ^ "\n"

let whole c = text c ~kept:(fun _ -> true)
let print c = whole c c.events

(* What is counted is no draw and no lot, and speaks of no leaf, so that it can be asked of each part. *)
let events =
  [
    "event weak"; "event split"; "event weak or event absorb"; "event bounce or event weak"; "event absorb";
    "event split and not event strong";
  ]

let generate =
  let open Gen in
  let* laws = frequencyl [ (3, false); (1, true) ] in
  let* n = int_range 2 3 in
  let most = if laws then 2 else if n = 2 then 4 else 3 in
  let* clusters = list_repeat n (Told_otherwise.cluster ~most ~pushes:false ~laws) in
  let* timestep = if laws then oneofl [ "timestep 1 steady"; "timestep 1 local" ] else pure "" in
  let* events = list_repeat 2 (oneofl events) and* until = oneofl [ "1"; "2" ] in
  pure { clusters; timestep; events; until }

type count = { mutable asked : int; mutable undecided : int; mutable free : int }

let count = { asked = 0; undecided = 0; free = 0 }

let add a b =
  match (a, b) with Some (x, y), Some (z, w) -> Some (Rat.add x z, Rat.add y w) | None, _ | _, None -> None

let sum = List.fold_left add (Some (Rat.zero, Rat.zero))

let same a b =
  match (a, b) with
  | Some (x, y), Some (z, w) -> Rat.equal x z && Rat.equal y w
  | None, _ | _, None -> true

let note a =
  count.asked <- count.asked + 1;
  match a with
  | None -> count.undecided <- count.undecided + 1
  | Some (x, y) -> if not (Rat.equal x y) then count.free <- count.free + 1

let parts c events = List.mapi (fun k _ -> answers (text c ~kept:(Int.equal k) events)) c.clusters

let transposed rows = List.mapi (fun i _ -> List.map (fun row -> List.nth row i) rows) (List.hd rows)

let over_parts c =
  let found = answers (whole c c.events) in
  List.iter note found;
  List.for_all2 same found (List.map sum (transposed (parts c c.events)))

let of_parts =
  QCheck2.Test.make ~name:"Additivity: over parts that never meet" ~count:30 ~print generate over_parts

(* Of all bonds, each of which is one event of a split. Where there is something to choose one scheduler does not
   have to make all of them least. *)
let over_bonds c =
  let pair k (i, j, _) =
    let name l = Told_otherwise.leaf_name Told_otherwise.as_it_is (k, l) in
    Printf.sprintf "event weak(a, %s, %s)" (name i) (name j)
  in
  let pairs_of k (x : Told_otherwise.cluster) = List.map (pair k) x.bonds in
  let pairs = List.concat (List.mapi pairs_of c.clusters) in
  match answers (whole c ("event weak" :: pairs)) with
  | [] -> failwith "no answers"
  | all :: each -> (
      match (all, sum each) with
      | Some (x, y), Some (least, greatest) ->
        let in_order a b = Rat.compare a b <= 0 in
        in_order least x && in_order x y && in_order y greatest
        && (List.exists (function Some (x, y) -> not (Rat.equal x y) | None -> true) each || Rat.equal x least)
      | None, _ | _, None -> true)

let of_bonds = QCheck2.Test.make ~name:"Additivity: over bonds" ~count:15 ~print generate over_bonds

(* So that it is about something. *)
let scope () =
  Printf.printf "%d questions, %d undecided, %d of free choices\n" count.asked count.undecided count.free;
  Alcotest.(check bool) "most are decided" true (10 * count.undecided < 3 * count.asked);
  Alcotest.(check bool) "some depend on choices" true (20 * count.free > count.asked)

(* {1 Where the law says that it fails} *)

let choices () =
  let file = "../../../specs/models/laws/pairs.sc" in
  let changes overrides =
    let overrides = List.map (fun name -> (name, Rat.zero)) overrides in
    let e = Load.exactly (Load.file ~overrides file) in
    let semantics = Scc_engine.Standard.of_model e.model in
    let initial = Result.get_ok (Network.initial semantics e.declared) in
    let outcomes = (Check.run Setup.default semantics ~initial e.checks).outcomes in
    let last = List.nth outcomes (List.length outcomes - 1) in
    Option.fold ~none:"not known" ~some:(fun (x, _) -> Rat.to_string x) (answer last)
  in
  Alcotest.(check string) "one pair" "4/3" (changes [ "two" ]);
  Alcotest.(check string) "the other" "3/2" (changes [ "one" ]);
  Alcotest.(check string) "both" "3" (changes [])

let () =
  Alcotest.run "additivity"
    [
      ( "laws",
        Scc_test_support.Property.cases [ of_parts; of_bonds ]
        @ [ Alcotest.test_case "Additivity: fails for what is chosen" `Quick choices ] );
      ("scope", [ Alcotest.test_case "scope" `Quick scope ]);
    ]
