open Scc_base
open Scc_exact
open Scc_json
open Scc_runs

let case name f = Alcotest.test_case name `Quick f
let source text = Source.make ~name:"run.json" text

(* The first outputs for the seed 1234567, as published with the generator. *)
let generator () =
  let rec take n g = if n = 0 then [] else let x, g = Splitmix64.next g in x :: take (n - 1) g in
  let shown = List.map (Printf.sprintf "%Lu") (take 5 (Splitmix64.of_seed 1234567L)) in
  Alcotest.(check (list string)) "outputs"
    [
      "6457827717110365317"; "3203168211198807973"; "9817491932198370423"; "4593380528125082431";
      "16408922859458223821";
    ]
    shown

let below_is_in_range =
  QCheck2.Test.make ~name:"below n is in [0, n)" ~count:2000
    QCheck2.Gen.(pair (1 -- max_int) (map Int64.of_int int))
    (fun (n, seed) ->
       let k, _ = Splitmix64.below n (Splitmix64.of_seed seed) in
       0 <= k && k < n)

let below_is_fair () =
  let counts = Array.make 3 0 in
  let rec go n g =
    if n > 0 then begin
      let k, g = Splitmix64.below 3 g in
      counts.(k) <- counts.(k) + 1;
      go (n - 1) g
    end
  in
  go 3000 (Splitmix64.of_seed 1L);
  Array.iter (fun c -> Alcotest.(check bool) "near a third" true (c > 900 && c < 1100)) counts

let text () =
  let check name expected s = Alcotest.(check string) name expected (Json.line (Json.text s)) in
  check "UTF-8 stays" "\"\xcf\x89 \xe2\x80\x96\"" "\xcf\x89 \xe2\x80\x96";
  check "a stray byte" "\"a\xef\xbf\xbdb\"" "a\xffb";
  check "an overlong form" "\"\xef\xbf\xbd\xef\xbf\xbd\"" "\xc0\x80";
  check "a surrogate" "\"\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\"" "\xed\xa0\x80";
  check "a change of direction" "\"a\\u202eb\\u2066\xe2\x80\xa9\"" "a\xe2\x80\xaeb\xe2\x81\xa6\xe2\x80\xa9";
  check "quotes and controls" "\"\\\"\\n\\u0001\"" "\"\n\001"

let numbers () =
  Alcotest.(check string) "integer" "\"-3/1\"" (Json.line (Json.rat (Rat.of_int (-3))));
  Alcotest.(check string) "lowest terms" "\"1/2\"" (Json.line (Json.rat (Rat.make (Z.of_int 2) (Z.of_int 4))))

let deep () =
  let nested = String.make 1_000_000 '[' in
  Alcotest.(check bool) "refused" true (Result.is_error (Json.parse (source nested)));
  Alcotest.(check bool) "brackets in texts do not count" true
    (Result.is_ok (Json.parse (source (Printf.sprintf "\"%s\"" nested))))

let choices = [ (0, "time(1/2)"); (3, "strong({<a, {p.right, q.left}>})") ]

let digest_text = "md5:0123456789abcdef0123456789abcdef"

let round_trip () =
  let half = Rat.make Z.one (Z.of_int 2) in
  let text =
    Schedule.made
      { name = None; digest = digest_text; parameters = [ ("n", Rat.of_int 4) ]; settings = [] }
      choices ~offset:(Some half)
    |> Schedule.to_string
  in
  match Schedule.read (source text) with
  | Error d -> Alcotest.fail d.Diag.message
  | Ok s ->
    let back (c : Schedule.choice) = (Option.get c.index, Option.get c.label) in
    Alcotest.(check (list (pair int string))) "choices" choices (List.map back s.choices);
    Alcotest.(check (option string)) "offset" (Some "1/2") (Option.map Rat.to_string s.offset);
    Alcotest.(check (option string)) "digest" (Some digest_text) s.digest;
    let starts (c : Schedule.choice) = text.[c.at.Span.start] in
    Alcotest.(check (list char)) "each choice knows its place" [ '{'; '{' ] (List.map starts s.choices)

let of_trace () =
  let text =
    {|{"type":"header","format":"scc-trace","version":1,"parameters":{"n":"4/1"}}
{"type":"state","time":"0/1"}
{"type":"transition","choice":1,"label":{"kind":"time","text":"time(1)"}}
{"type":"instant","offset":"1/3"}
{"type":"end"}
|}
  in
  match Schedule.read (source text) with
  | Error d -> Alcotest.fail d.Diag.message
  | Ok s ->
    Alcotest.(check int) "one choice" 1 (List.length s.choices);
    Alcotest.(check (option string)) "offset" (Some "1/3") (Option.map Rat.to_string s.offset);
    Alcotest.(check (list string)) "parameters" [ "n" ] (List.map fst s.parameters)

let refused =
  let schedule body = Printf.sprintf {|{ "format": "scc-schedule", "version": 1, %s }|} body in
  [
    ("empty", "");
    ("not JSON", "{ \"format\": ");
    ("another document", {|{ "format": "other" }|});
    ("another version", {|{ "format": "scc-schedule", "version": 3, "choices": [] }|});
    ("no version", {|{ "format": "scc-schedule", "choices": [] }|});
    ("no choices", schedule {|"parameters": {}|});
    ("empty choice", schedule {|"choices": [ {} ]|});
    ("negative choice", schedule {|"choices": [ { "choice": -1 } ]|});
    ("choice of a wrong type", schedule {|"choices": [ { "choice": "0" } ]|});
    ("negative offset", schedule {|"choices": [], "offset": "-1/2"|});
    ("offset that is no number", schedule {|"choices": [], "offset": "1/0"|});
    ("parameter that is no number", schedule {|"choices": [], "parameters": { "n": [] }|});
    ("a line that is none", "{\"format\":\"scc-trace\",\"version\":1}\n{\"type\":\"other\"}\n");
  ]

let refuse (name, text) =
  case name (fun () ->
      match Schedule.read (source text) with
      | Ok _ -> Alcotest.fail "read"
      | Error d -> Alcotest.(check string) "code" "SC0801" d.Diag.code)

(* The model of a start that a witness is of. *)
let at_values () =
  let text =
    "param n = 2 param x in [0, 6] param y in (0, 1) shape Cube = box(2, 2, 2) \
     process p = Cube mass 1 at translate (n*x, y, 0) [eps(x + y). nil]"
  in
  let no_files _ = Error "no files here" in
  let load () = Scc_loading.Loaded.load ~read_file:no_files ~overrides:[ ("n", Rat.of_int 3) ] (source text) in
  let half = Rat.make Z.one (Z.of_int 2) in
  match load () with
  | Error _ -> Alcotest.fail "the model"
  | Ok l ->
    Alcotest.(check bool) "not of one point" true (Result.is_error (Scc_loading.Ordinary.at_point l));
    (match Scc_loading.Loaded.at l [ ("x", Rat.of_int 5); ("y", half) ] with
     | Error _ -> Alcotest.fail "the values are within"
     | Ok fixed ->
       let leaf = fixed.declared.Scc_calculus.State.processes.(0).leaves.(0) in
       Alcotest.(check string) "its place" "(15, 1/2, 0)" (Vec.to_string leaf.position);
       Alcotest.(check bool) "of one point" true (Result.is_ok (Scc_loading.Ordinary.at_point fixed));
       Alcotest.(check (list string)) "what is given" [ "n"; "x"; "y" ] (List.map fst fixed.origin.parameters);
       Alcotest.(check string) "the same text" l.origin.digest fixed.origin.digest);
    match Scc_loading.Loaded.at l [ ("y", Rat.one) ] with
    | Ok _ -> Alcotest.fail "the end is left out"
    | Error diagnostics ->
      Alcotest.(check (list string)) "beyond" [ "SC0217" ] (List.map (fun (d : Diag.t) -> d.code) diagnostics)

let digest () =
  let make text files = Scc_loading.Origin.digest ~text ~files in
  Alcotest.(check bool) "text" false (String.equal (make "a" []) (make "b" []));
  Alcotest.(check bool) "where a file begins" false
    (String.equal (make "a" [ ("f", "xy") ]) (make "a" [ ("fx", "y") ]));
  Alcotest.(check string) "MD5 of 0:0:" "md5:d8f6008c2af33aceef0d865fd73192f1" (make "" [])

(* {1 Long numbers for people} *)

let short () =
  let power n = Q.of_bigint (Z.pow (Z.of_int 10) n) in
  let long = Q.make (Z.add (Z.pow (Z.of_int 7) 60) Z.one) (Z.pow (Z.of_int 7) 60) in
  let told what expected q = Alcotest.(check string) what expected (Scc_runs.Short_text.exact q) in
  told "exact" "-22/7" (Q.of_ints (-22) 7);
  told "up to 60 characters" (Q.to_string (power 59)) (power 59);
  told "a fraction" "~1.000000 (103 characters)" long;
  told "great" "1e60 (61 characters)" (power 60);
  told "great, rounded" "~1.000000e60 (61 characters)" (Q.add (power 60) Q.one);
  told "to the nearest" "137174210/109739369 (~1.250000)" (Q.of_ints 137174210 109739369);
  told "a decimal" "123456789001/10000 (12345678.9001)" (Q.of_ints 123456789001 10000);
  told "small" "1e-70 (73 characters)" (Q.inv (power 70));
  told "negative" "-2e-70 (73 characters)" (Q.neg (Q.div (Q.of_int 2) (power 70)));
  told "not plain any more" "~1.000000e-3 (119 characters)" (Q.sub (Q.of_ints 1 1000) (Q.inv (power 60)))

let () =
  Alcotest.run "exchange"
    [
      ("generator", [ case "reference outputs" generator; case "fair" below_is_fair ]
                    @ Scc_test_support.Property.cases [ below_is_in_range ]);
      ("json", [ case "texts" text; case "rationals" numbers; case "nesting" deep ]);
      ("schedule", [ case "written and read" round_trip; case "of a trace" of_trace ]);
      ("refused schedules", List.map refuse refused);
      ("digest", [ case "tells models apart" digest ]);
      ("ranges", [ case "the model at values" at_values ]);
      ("text", [ case "long numbers" short ]);
    ]
