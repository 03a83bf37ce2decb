(* Formulas along paths, by `values`; texts in canonical layout; and files that the surroundings have. *)

open Scc_exact
open Scc_oracle
open Oracle_cases
open Asking

let list = Yojson.Basic.Util.to_list

let number : json -> Rat.t = function
  | `String s -> Result.get_ok (Rat.of_literal s)
  | _ -> Alcotest.fail "no number"

let values session path formula =
  let p = [ ("model", `String "m1"); ("path", params path); ("formula", `String formula) ] in
  ask session "values" (`Assoc p)

let told session path formula = list (member "values" (member "result" (values session path formula)))

let cube name =
  let lines = List.filteri (fun i _ -> i >= 3 && i < 8) (String.split_on_char '\n' Cases.model) in
  String.concat "\n" (("shape " ^ name ^ " {") :: lines) ^ "\n"

(* p comes from 0 by 1, q from 5 by -1, they meet at 3/2 and bind, are released, and part as they came. *)
let by_hand () =
  let session = create () in
  let check formula path expected =
    check_text (formula ^ " along " ^ path)
      (shown (params expected))
      (shown (`List (told session path formula)))
  in
  check "x(p)" "[]" {|[{"n":["0/1","1/1"],"d":["1/1"]}]|};
  check "x(p)" "[0]" {|[{"n":["0/1","1/1"],"d":["1/1"]},{"n":["3/2"],"d":["1/1"]}]|};
  check "time" "[0,0]"
    {|[{"n":["0/1","1/1"],"d":["1/1"]},{"n":["3/2"],"d":["1/1"]},{"n":["3/2","1/1"],"d":["1/1"]}]|};
  check "distance2(p, q)" "[0]" {|[{"n":["25/1","-20/1","4/1"],"d":["1/1"]},{"n":["4/1"],"d":["1/1"]}]|};
  check "bonds(k) = 1" "[0,0]"
    {|[{"n":["0/1"],"d":["1/1"]},{"n":["0/1"],"d":["1/1"]},{"n":["1/1"],"d":["1/1"]}]|};
  (* what holds at an instant alone *)
  check "x(p) = 1" "[]"
    {|[{"pieces":[{"from":"0/1","n":["0/1"],"d":["1/1"]},{"from":"1/1","n":["1/1"],"d":["1/1"]},
       {"from":"1/1","n":["0/1"],"d":["1/1"]}]}]|};
  check "event bind(k)" "[0,0]"
    {|[{"n":["0/1"],"d":["1/1"]},{"n":["0/1"],"d":["1/1"]},
       {"pieces":[{"from":"0/1","n":["1/1"],"d":["1/1"]},{"from":"0/1","n":["0/1"],"d":["1/1"]}]}]|};
  check "1 / vx(wall) > 0" "[]" {|[{"none":"division by zero in (1 / vx(wall))"}]|};
  let kind formula = shown (member "kind" (member "result" (values session "[0]" formula))) in
  check_text "a number" {|"number"|} (kind "x(p)");
  check_text "a state predicate" {|"state"|} (kind "quiescent");
  let refused formula path = code (values session path formula) in
  Alcotest.(check int) "a temporal formula" (-32602) (refused "possibly bonds(k) = 1" "[]");
  Alcotest.(check int) "no formula" (-32007) (refused "bonds(" "[]");
  Alcotest.(check int) "no way" (-32005) (refused "time" "[0,7]");
  let short = create ~quotas:{ Quotas.default with path = 1 } () in
  Alcotest.(check int) "a long way" (-32000) (code (values short "[0,0]" "time"))

(* Of 2^(1/2) a rational right before it. *)
let irrational () =
  match told (create ()) "[]" "x(p) * x(p) < 2" with
  | [ piece ] ->
    let begins = List.map (fun p -> number (member "from" p)) (list (member "pieces" piece)) in
    let square x = Rat.mul x x in
    let two = Rat.of_int 2 and near = Rat.make Z.one (Z.pow (Z.of_int 10) 12) in
    let close x = Rat.compare (square x) two < 0 && Rat.compare (square (Rat.add x near)) two > 0 in
    (match begins with
     | [ zero; root ] -> Alcotest.(check bool) "near" true (Rat.equal zero Rat.zero && close root)
     | _ -> Alcotest.fail "it changes once")
  | _ -> Alcotest.fail "one state"

(* A network at rest: what it is, for ever. *)
let at_rest () =
  let session = create () in
  let text = cube "Cube" ^ "fixed wall = Cube at translate (12, 0, 0)\n" in
  let loaded = ask session "model.load" (`Assoc [ ("text", `String text) ]) in
  check_text "loaded" {|"m2"|} (shown (member "model" (member "result" loaded)));
  let p = `Assoc [ ("model", `String "m2"); ("formula", `String "x(wall) - time") ] in
  check_text "for ever" {|[{"n":["12/1","-1/1"],"d":["1/1"]}]|}
    (shown (member "values" (member "result" (ask session "values" p))))

(* {1 Against `evaluate`} *)

let horner coefficients t =
  List.fold_left (fun sum c -> Rat.add (Rat.mul sum t) (number c)) Rat.zero (List.rev coefficients)

(* At the state itself: what the first piece says. *)
let at_start piece =
  let piece = match member "pieces" piece with `Null -> piece | pieces -> List.hd (list pieces) in
  match member "n" piece with
  | `Null -> None
  | n -> Some (Rat.div (horner (list n) Rat.zero) (horner (list (member "d" piece)) Rat.zero))

let formulas =
  [ "x(p)"; "distance2(p, q)"; "time"; "1 / (x(p) - 3/2)"; "bonds(k) = 1"; "event bind(k)"; "vx(p) > 0"; "energy" ]

let evaluated session path formula =
  let path = `List (List.map (fun k -> `Int k) path) in
  let p = `Assoc [ ("model", `String "m1"); ("path", path); ("formula", `String formula) ] in
  match member "value" (member "result" (ask session "evaluate" p)) with
  | `Bool b -> Some (if b then Rat.one else Rat.zero)
  | `Null -> None
  | v -> Some (number (member "exact" v))

let as_evaluated () =
  let session = create () in
  let rec prefixes = function [] -> [ [] ] | k :: rest -> [] :: List.map (List.cons k) (prefixes rest) in
  let run = result session "replay" {|{"model":"m1","choose":"first","steps":12,"states":"ends"}|} in
  let path = List.init (Yojson.Basic.Util.to_int (member "steps" run)) (fun _ -> 0) in
  Alcotest.(check bool) "some steps" true (List.length path > 2);
  let of_path = shown (`List (List.map (fun k -> `Int k) path)) in
  let check formula =
    let expected = List.map (fun path -> evaluated session path formula) (prefixes path) in
    let found = List.map at_start (told session of_path formula) in
    let text = Option.fold ~none:"none" ~some:Rat.to_string in
    Alcotest.(check (list string)) formula (List.map text expected) (List.map text found)
  in
  List.iter check formulas

(* {1 Texts} *)

let layout () =
  let session = create () in
  let format text = `Assoc [ ("text", `String text) ] in
  let formatted text = member "text" (member "result" (ask session "text.format" (format text))) in
  let once = formatted Cases.model in
  check_text "layout" {|"// kept\nmodel x\n"|} (shown (formatted "// kept\n  model   x"));
  (match once with
   | `String s -> check_text "and again" (shown once) (shown (formatted s))
   | _ -> Alcotest.fail "no text");
  let refused quotas p =
    let session = create ~quotas () in
    code (ask session "text.format" p)
  in
  let q = Quotas.default in
  let named = `Assoc [ ("text", `String ""); ("name", `String "xyz.sc") ] in
  Alcotest.(check int) "no text of the language" (-32003) (refused q (format "model"));
  Alcotest.(check int) "a long text" (-32000) (refused { q with model_bytes = 300 } (format Cases.model));
  Alcotest.(check int) "a long name" (-32000) (refused { q with name_bytes = 5 } named)

(* {1 Files} *)

let importing = `Assoc [ ("text", `String {|import "parts/other.sc" (Part)
process p = Part mass 1 [nil]
|}) ]

let with_files more =
  match importing with `Assoc members -> `Assoc (members @ more) | other -> other

let other = cube "Part"

let files () =
  let asked = ref [] in
  let read_file name =
    asked := name :: !asked;
    if String.equal name "parts/other.sc" then Ok other else Error "it is not there"
  in
  let reading = create ~surroundings:{ Session.quiet with read_file } () in
  let none = create () in
  let loads session p = match member "result" (ask session "model.load" p) with `Null -> false | _ -> true in
  Alcotest.(check bool) "read" true (loads reading importing);
  Alcotest.(check (list text)) "what is asked for" [ "parts/other.sc" ] (List.sort_uniq compare !asked);
  Alcotest.(check bool) "there are none" false (loads none importing);
  asked := [];
  let given = with_files [ ("files", `Assoc [ ("parts/other.sc", `String other) ]) ] in
  Alcotest.(check bool) "given" true (loads none given);
  Alcotest.(check bool) "given, and not read" true (loads reading given && !asked = [])

let () =
  Alcotest.run "oracle along paths"
    [
      ( "values",
        [
          case "by hand" by_hand;
          case "irrational" irrational;
          case "at rest" at_rest;
          case "as evaluated" as_evaluated;
        ] );
      ("texts", [ case "layout" layout ]);
      ("files", [ case "read" files ]);
    ]
