open Scc_exact
open Scc_geometry
open Scc_oracle
open Oracle_cases
open Asking
module Random = Scc_runs.Splitmix64

let rat q = `String (Printf.sprintf "%s/%s" (Z.to_string q.Q.num) (Z.to_string q.Q.den))
let vec (v : Vec.t) : json = `List [ rat v.x; rat v.y; rat v.z ]

(* {1 Geometry, against the library} *)

let solid (j : json) id =
  let open Yojson.Basic.Util in
  let number = function
    | `Int n -> Rat.of_int n
    | `Float x -> Q.of_float x
    | `String s -> Result.get_ok (Rat.of_literal s)
    | _ -> Alcotest.fail "no number"
  in
  let vertex i v =
    match List.map number (to_list v) with
    | [ x; y; z ] -> ("v" ^ string_of_int i, Vec.make x y z)
    | _ -> Alcotest.fail "no vector"
  in
  let face i f = ("f" ^ string_of_int i, Array.of_list (List.map to_int (to_list f))) in
  let set : Polyhedron.ifs =
    {
      ifs_vertices = Array.of_list (List.mapi vertex (to_list (member "vertices" j)));
      ifs_faces = Array.of_list (List.mapi face (to_list (member "faces" j)));
    }
  in
  Solid.make ~id (Result.get_ok (Polyhedron.of_ifs set)) Mat.identity

let cube = solid Cases.cube 1
let tetrahedron = solid Cases.tetrahedron 2

(* Small fractions, so that there are grazes and touches. *)
let random_vector g =
  let number g =
    let n, g = Random.below 17 g in
    let d, g = Random.below 4 g in
    (Rat.make (Z.of_int (n - 8)) (Z.of_int (d + 1)), g)
  in
  let x, g = number g in
  let y, g = number g in
  let z, g = number g in
  (Vec.make x y z, g)

let rec times n f g = if n > 0 then times (n - 1) f (f g)

let casts () =
  let session = create () in
  let pairs = [ ("s1", "s2", Obstacle.make cube tetrahedron); ("s1", "s1", Obstacle.make cube cube) ] in
  let seen = Array.make 3 0 in
  let one (a, b, o) r w =
    let expected : json =
      match Obstacle.first_time_of_contact o r w with
      | Never ->
        seen.(0) <- seen.(0) + 1;
        `Assoc [ ("outcome", `String "never"); ("time", `Null) ]
      | Inside ->
        seen.(1) <- seen.(1) + 1;
        `Assoc [ ("outcome", `String "inside"); ("time", `Null) ]
      | At t ->
        seen.(2) <- seen.(2) + 1;
        `Assoc
          [
            ("outcome", `String "at");
            ("time", `Assoc [ ("exact", rat t); ("float", `Float (Rat.to_float t)) ]);
          ]
    in
    let p = `Assoc [ ("a", `String a); ("b", `String b); ("offset", vec r); ("velocity", vec w) ] in
    check_text "cast" (shown expected) (shown (member "result" (ask session "first_time_of_contact" p)))
  in
  times 1000
    (fun g ->
       let r, g = random_vector g in
       let w, g = random_vector g in
       List.iter (fun pair -> one pair r w) pairs;
       g)
    (Random.of_seed 3L);
  Array.iter (fun n -> Alcotest.(check bool) "each outcome is seen" true (n > 20)) seen

let contacts () =
  let session = create () in
  let o = Obstacle.make cube cube in
  let touching = ref 0 in
  times 1000
    (fun g ->
       let r, g = random_vector g in
       let w, g = random_vector g in
       let p =
         `Assoc [ ("a", `String "s1"); ("b", `String "s1"); ("offset", vec r); ("velocity", vec w) ]
       in
       let answer = member "result" (ask session "contact" p) in
       let relation = Obstacle.relation o r in
       check_text "relation" (shown (`String (Contacts.relation relation))) (shown (member "relation" answer));
       (match relation with
        | Touching ->
          incr touching;
          let count name = List.length (Yojson.Basic.Util.to_list (member name answer)) in
          check_text "region" (shown (`List (List.map vec (Contact.region o r)))) (shown (member "region" answer));
          Alcotest.(check int) "pairs" (List.length (Contact.touching o r)) (count "pairs");
          Alcotest.(check int) "normals" (List.length (Obstacle.separating o r)) (count "normals");
          let approaching = `Bool (Obstacle.approaching o r w) in
          check_text "approaching" (shown approaching) (shown (member "approaching" answer))
        | Apart | Interpenetrating -> check_text "region" "null" (shown (member "region" answer)));
       g)
    (Random.of_seed 5L);
  Alcotest.(check bool) "some touch" true (!touching > 20)

(* A rigid cast of what does not turn is the other one, rounded down. *)
let rigid_casts () =
  let session = create () in
  let at p = member "exact" (member "time" (result session "first_time_of_contact" p)) in
  let plain = {|"a":"s1","b":"s2","offset":[4,"1/3",0],"velocity":[-3,0,"1/7"]|} in
  check_text "exact" {|"1/1"|} (shown (at ("{" ^ plain ^ "}")));
  check_text "on the grid" {|"1/1"|} (shown (at ("{" ^ plain ^ {|,"span":4,"grid":10}|})));
  let beyond = result session "first_time_of_contact" ("{" ^ plain ^ {|,"span":1,"grid":10}|}) in
  check_text "beyond the span" "null" (shown (member "time" beyond))

(* Energy and momentum are kept. *)
let responses () =
  let session = create () in
  let p =
    {|{"touching":[{"a":"s1","b":"s1","offset":[2,"1/3",0]}],"first":{"mass":1,"velocity":[1,"1/2",0]},
       "second":{"mass":3,"velocity":[0,0,"1/5"]}}|}
  in
  check_text "response"
    {|{"outcome":"bounced","first":{"velocity":["-1/2","1/2","0/1"]},"second":{"velocity":["1/2","0/1","1/5"]}}|}
    (shown (result session "response" p))

(* {1 Numbers} *)

let numbers () =
  let session = create () in
  let volume x =
    let p = Printf.sprintf {|{"shape":"s1","mass":%s}|} x in
    let answer = line session (Printf.sprintf {|{"jsonrpc":"2.0","id":1,"method":"shape.mass","params":%s}|} p) in
    match member "result" answer with
    | `Null -> string_of_int (code answer)
    | r -> Yojson.Basic.Util.(to_string (member "mass" r))
  in
  let check given expected = check_text given expected (volume given) in
  check "0.1" "1/10";
  check "1e-3" "1/1000";
  check "12.50E+2" "1250/1";
  check "9007199254740993" "9007199254740993/1";
  check "123456789012345678901234567890" "123456789012345678901234567890/1";
  check {|"7/3"|} "7/3";
  check {|"0.25"|} "1/4";
  check "1e999" ("1" ^ String.make 999 '0' ^ "/1");
  check "1e1000" "-32000";
  check "1e-1000" "-32000";
  check "1e999999999" "-32000";
  check ("1" ^ String.make 100_000 '0') "-32000";
  List.iter
    (fun s -> check s "-32602")
    [ "0"; "-1"; {|"1/0"|}; {|"x"|}; {|"NaN"|}; "[]"; "true"; {|""|}; {|"0x10"|}; {|" 1"|} ];
  (* Seeds. *)
  ignore (line session {|{"jsonrpc":"2.0","id":1,"method":"model.load","params":{"text":"param n = 1"}}|});
  let replay = {|{"jsonrpc":"2.0","id":1,"method":"replay","params":{"model":"m1","choose":{"random":|} in
  let refused s = List.mem_assoc "error" (Yojson.Basic.Util.to_assoc (line session (replay ^ s ^ "}}}"))) in
  Alcotest.(check (list string)) "refused" [ {|"0x1f"|}; {|"1_0"|}; {|"-"|} ]
    (List.filter refused [ "7"; {|"-7"|}; {|"0x1f"|}; {|"1_0"|}; {|"-"|} ])

(* {1 Messages} *)

let id_and_code s =
  let session = create () in
  let answer = line session s in
  (shown (member "id" answer), code answer)

let malformed () =
  let check s id expected =
    Alcotest.(check (pair text int)) s (id, expected) (id_and_code s)
  in
  List.iter
    (fun s -> check s "null" (-32700))
    [
      "{"; "x"; "[1,]"; "{\"a\":1,}"; "01"; "1."; ".5"; "+1"; "NaN"; "Infinity"; "'a'"; "// c"; "\"a"; "\"\\x\"";
      "\"\\ud800\""; "\"\\udc00\\ud800\""; "\"\x01\""; "\"\xff\""; "\"\xc0\x80\""; "\"\xed\xa0\x80\"";
      "{} {}"; "tru";
      "\xef\xbb\xbf{}"; {|{"id":1,"id":1}|}; {|{"params":{"a":1,"a":2}}|}; "\x00"; "[}"; "-"; "1e"; "{1:2}";
    ];
  List.iter
    (fun s -> check s "null" (-32600))
    [ "[]"; "1"; "null"; {|"x"|}; "{}"; {|{"jsonrpc":"2.0","id":{},"method":"contact"}|};
      {|{"jsonrpc":"2.0","id":1.0,"method":"contact"}|} ];
  check {|{"jsonrpc":"2.0","id":"a\"b","method":1}|} {|"a\"b"|} (-32600);
  check {|{"jsonrpc":"2.0","id":3,"method":"contact","more":1}|} "3" (-32600);
  check {|{"jsonrpc":"2.0","id":-3,"method":"contacts"}|} "-3" (-32601);
  check {|{"jsonrpc":"2.0","id":null,"method":"contact"}|} "null" (-32602)

let nested () =
  let deep n = String.make n '[' ^ String.make n ']' in
  Alcotest.(check int) "64 deep" (-32600) (code (line (create ()) ({|{"a":|} ^ deep 63 ^ "}")));
  List.iter
    (fun n -> Alcotest.(check int) (string_of_int n) (-32000) (code (line (create ()) (deep n))))
    [ 65; 1000; 5_000_000 ]

let batches () =
  let session = create () in
  let request id = Printf.sprintf {|{"jsonrpc":"2.0",%s"method":"shape.mass","params":{"shape":"s1"}}|} id in
  let mixed = [ request {|"id":2,|}; request ""; "7"; request {|"id":1,|} ] in
  let answer = line session ("[" ^ String.concat "," mixed ^ "]") in
  let ids = List.map (fun r -> shown (member "id" r)) (Yojson.Basic.Util.to_list answer) in
  Alcotest.(check (list text)) "in order, nothing for the notification" [ "2"; "null"; "1" ] ids;
  let none = Alcotest.(check (option text)) in
  none "a notification" None (Oracle.handle session (request ""));
  let wrong = {|{"jsonrpc":"2.0","method":"x","params":[]}|} in
  none "a notification with wrong params" None (Oracle.handle session wrong);
  none "a batch of notifications" None (Oracle.handle session ("[" ^ request "" ^ "," ^ wrong ^ "]"));
  none "blanks" None (Oracle.handle session " \t\r");
  let release = {|{"jsonrpc":"2.0","method":"shape.release","params":{"shape":"s2"}}|} in
  none "a release" None (Oracle.handle session release);
  Alcotest.(check int) "is carried out" (-32001) (refused session "shape.mass" {|{"shape":"s2"}|})

(* {1 Handles and limits} *)

let handles () =
  let session = create ~quotas:{ Quotas.default with shapes = 3 } () in
  let define () = ask session "shape.define" Cases.cube in
  check_text "the next one" {|"s3"|} (shown (member "shape" (member "result" (define ()))));
  Alcotest.(check int) "full" (-32000) (code (define ()));
  ignore (result session "shape.release" {|{"shape":"s2"}|});
  check_text "never used twice" {|"s4"|} (shown (member "shape" (member "result" (define ()))));
  Alcotest.(check int) "released" (-32001) (refused session "shape.release" {|{"shape":"s2"}|})

let limits () =
  let q = Quotas.default in
  let check name quotas asked p =
    let session = create ~quotas () in
    let answer = ask session asked (params p) in
    Alcotest.(check int) name (-32000) (code answer);
    check_text name (shown (`String name)) (shown (member "limit" (member "data" (member "error" answer))))
  in
  let set = {|{"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"faces":[[0,2,1],[0,1,3],[1,2,3],[0,3,2]]}|} in
  check "vertices" { q with vertices = 3 } "shape.check" set;
  check "faces" { q with faces = 3 } "shape.check" set;
  check "corners" { q with corners = 11 } "shape.check" set;
  check "digits" { q with digits = 3 } "shape.mass" {|{"shape":"s1","mass":"1/1000"}|};
  check "path" { q with path = 1 } "successors" {|{"model":"m1","path":[0,0]}|};
  check "steps" { q with steps = 1 } "replay" {|{"model":"m1","choices":[0,0]}|};
  check "steps" { q with steps = 1 } "replay" {|{"model":"m1","choose":"first","steps":2}|};
  check "grid" { q with grid = 3 } "first_time_of_contact"
    {|{"a":"s1","b":"s1","offset":[4,0,0],"velocity":[1,0,0],"span":1,"grid":4}|};
  check "formula_bytes" { q with formula_bytes = 3 } "evaluate" {|{"model":"m1","formula":"true"}|};
  check "states" { q with states = 3 } "evaluate"
    {|{"model":"m1","formula":"possibly bonds(k) = 1","limits":{"states":4}}|};
  check "touching" { q with touching = 0 } "response" {|{"touching":[1],"first":{},"second":{}}|};
  check "reply_bytes" { q with reply_bytes = 600 } "successors" {|{"model":"m1"}|};
  check "reply_bytes" { q with reply_bytes = 600 } "replay" {|{"model":"m1","choose":"first"}|};
  let few = create ~quotas:{ q with values = 1000; batch = 3 } () in
  let many = "[" ^ String.concat "," (List.init 2000 (fun _ -> "1")) ^ "]" in
  Alcotest.(check int) "values" (-32000) (code (line few many));
  Alcotest.(check int) "batch" (-32000) (code (line few "[1,1,1,1]"));
  Alcotest.(check int) "line" (-32000) (code (Yojson.Basic.from_string (Oracle.too_long few)))

(* {1 Nothing lasts} *)

(* Those that give no handle. *)
let questions = List.filter (fun (name, _) -> not (String.equal name "shape.define")) Cases.valid
let answers session = List.map (fun (name, p) -> shown (ask session name p)) questions

let independence () =
  let fresh = List.map (fun (name, p) -> shown (ask (create ()) name p)) questions in
  let session = create () in
  let check what = Alcotest.(check (list text)) what fresh in
  check "one after the other" (answers session);
  check "and again" (answers session);
  Session.distrust session;
  check "after a request that failed" (answers session)

(* A request that is given up in its midst, by an exception. *)
exception Late

let stopped () =
  let stop = ref false in
  let bounded ~seconds:_ f =
    match
      let x = f () in
      if !stop then raise Late else x
    with
    | x -> Ok x
    | exception Late -> Error Fault.Seconds
  in
  let session = create ~surroundings:{ Session.quiet with bounded } () in
  let before = answers session in
  stop := true;
  List.iter (fun (name, p) -> Alcotest.(check int) name (-32004) (code (ask session name p))) Cases.valid;
  stop := false;
  Alcotest.(check (list text)) "as before" before (answers session)

let internal () =
  let raised = ref Not_found in
  let bounded ~seconds:_ _ = raise !raised in
  let session = create ~surroundings:{ Session.quiet with bounded } () in
  List.iter
    (fun e ->
       raised := e;
       Alcotest.(check int) (Printexc.to_string e) (-32603) (refused session "service.describe" "{}"))
    [ Not_found; Exit; Stack_overflow; Out_of_memory; Failure "x"; Scc_base.Bug.Bug (__POS__, "y") ]

(* {1 Models} *)

let states () =
  let session = create () in
  let state p = shown (member "state" (result session "successors" p)) in
  let stepped = shown (member "state" (result session "step" {|{"model":"m1","path":[0,0],"choice":0}|})) in
  check_text "a step leads where its path does" stepped (state {|{"model":"m1","path":[0,0,0]}|});
  check_text "asked for at once, too" stepped
    (shown (member "state" (result (create ()) "successors" {|{"model":"m1","path":[0,0,0]}|})))

let evaluate () =
  let session = create () in
  let check formula path expected =
    let p = [ ("model", `String "m1"); ("path", params path); ("formula", `String formula) ] in
    let answer = ask session "evaluate" (`Assoc p) in
    let told =
      match member "result" answer with
      | `Null -> string_of_int (code answer)
      | r -> (
          match member "kind" r with
          | `String "temporal" -> shown (member "verdict" r)
          | _ -> shown (member "value" r))
    in
    check_text (formula ^ " at " ^ path) expected told
  in
  check "bonds(k) = 1" "[0,0]" "true";
  check "bonds(k) = 1" "[0]" "false";
  check "event bind(k, p, q)" "[0,0]" "true";
  check "event bind(k, p, q)" "[]" "false";
  check "time" "[0]" {|{"exact":"3/2","float":1.5}|};
  check "x(p) + speed" "[0]" {|{"exact":"5/2","float":2.5}|};
  check "1 / bonds(k)" "[0]" "null";
  check "1 / bonds(k) = 1" "[0]" "null";
  check "possibly bonds(k) = 1 within 3/2" "[]" {|"holds"|};
  check "possibly bonds(k) = 1 within 1" "[]" {|"violated"|};
  check "eventually bonds(k) = 1 within 0" "[0]" {|"holds"|};
  check "true" "[]" "true";
  check "3" "[]" {|{"exact":"3/1","float":3.0}|};
  check "colour" "[]" "-32007";
  check "possibly (" "[]" "-32007";
  check "" "[]" "-32007";
  check (String.make 60_000 '(') "[]" "-32007";
  check "true" "[7]" "-32005"

let () =
  Alcotest.run "oracle"
    [
      ( "geometry",
        [
          case "casts" casts;
          case "contacts" contacts;
          case "rigid casts" rigid_casts;
          case "response" responses;
        ] );
      ( "messages",
        [
          case "numbers" numbers;
          case "malformed" malformed;
          case "nested" nested;
          case "batches" batches;
        ] );
      ("limits", [ case "handles" handles; case "limits" limits ]);
      ("sessions", [ case "independence" independence; case "stopped" stopped; case "internal errors" internal ]);
      ("models", [ case "states" states; case "evaluate" evaluate ]);
    ]
