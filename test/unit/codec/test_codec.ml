(* States as bytes: there and back, one way only, and nothing else is read. *)

open Scc_exact
open Scc_calculus
open Scc_codec
open Scc_test_networks
open Scc_test_models

let folder = "../../../specs/models"

let models =
  let names = Sys.readdir folder in
  Array.sort String.compare names;
  List.filter (fun name -> Filename.check_suffix name ".sc") (Array.to_list names)

let decoded codec text = State_codec.decode codec text

let comes_back codec state =
  match decoded codec (State_codec.encode codec state) with
  | Ok again -> State.equal again state
  | Error what -> Alcotest.failf "it is not read: %s" what

(* {1 Models} *)

let limit = 150

(* Parameters that have ranges are no part of a state, but of a set of states. *)
let start name =
  let { Scc_elaborate.Elaborate.model; declared; _ } =
    Load.exactly (Load.file (Filename.concat folder name))
  in
  if Array.length model.ranges = 0 then Some (model, Reach.initial model declared) else None

let round_trip name () =
  match start name with
  | None -> ()
  | Some (model, initial) ->
    let codec = State_codec.make model initial in
    (* Another process reads the same model. *)
    let another = match start name with Some (m, s) -> State_codec.make m s | None -> codec in
    let seen = Hashtbl.create 64 in
    let one (state, _) =
      let text = State_codec.encode codec state in
      Alcotest.(check bool) "the same bytes elsewhere" true (String.equal text (State_codec.encode another state));
      Alcotest.(check bool) "a state of its own" false (Hashtbl.mem seen text);
      Hashtbl.replace seen text ();
      match decoded another text with
      | Ok again -> Alcotest.(check bool) "the same state" true (State.equal again state)
      | Error what -> Alcotest.failf "it is not read: %s" what
    in
    List.iter one (Reach.states model initial ~limit)

(* {1 Random networks} *)

let law name count generator print start states =
  QCheck2.Test.make ~name ~count ~print generator (fun network ->
      let model, initial = start network in
      let codec = State_codec.make model initial in
      List.for_all (fun (state, _) -> comes_back codec state) (states model initial))

let straight =
  law "networks of all kinds" 60
    (Random_network.switched ~steered:true ())
    Random_network.print Random_network.start
    (fun model initial -> Reach.states model initial ~limit:20)

let rigid =
  let features = { Random_rigid.anything with rounds = true; laws = true; switched = true; draws = true } in
  law "networks that turn" 30 (Random_rigid.generate features) Random_rigid.print Random_rigid.start
    (fun model initial -> Rigid_reach.states ~limit:6 ~steps:6 model initial)

(* {1 Other bytes} *)

let samples =
  lazy
    (let of_model name =
       match start name with
       | None -> []
       | Some (model, initial) ->
         let codec = State_codec.make model initial in
         let text (state, _) = (codec, State_codec.encode codec state) in
         List.map text (Reach.states model initial ~limit:60)
     in
     let models = [ "raft.sc"; "brownian.sc"; "dissociation.sc"; "tumbling.sc"; "beat.sc" ] in
     Array.of_list (List.concat_map of_model models))

(* Whatever is changed: it is no state, or another one, with these very bytes. *)
let mutated =
  QCheck2.Test.make ~name:"damaged bytes" ~count:5000 ~print:string_of_int QCheck2.Gen.int (fun seed ->
      let rand = Random.State.make [| seed |] in
      let any = Random.State.int rand in
      let samples = Lazy.force samples in
      let codec, text = samples.(any (Array.length samples)) in
      let changed =
        match any 4 with
        | 0 -> String.sub text 0 (any (String.length text))
        | 1 -> text ^ String.make 1 (Char.chr (any 256))
        | _ ->
          let bytes = Bytes.of_string text in
          for _ = 0 to any 3 do
            Bytes.set bytes (any (Bytes.length bytes)) (Char.chr (any 256))
          done;
          Bytes.to_string bytes
      in
      match decoded codec changed with
      | Error what -> what <> ""
      | Ok state -> String.equal (State_codec.encode codec state) changed)

(* The example of specs/state-bytes.md. *)
let golden () =
  match start "figure4.sc" with
  | None -> Alcotest.fail "a model with ranges"
  | Some (model, initial) ->
    let digits c = Printf.sprintf "%02x" (Char.code c) in
    let hex text = String.concat "" (List.map digits (List.of_seq (String.to_seq text))) in
    let bytes = "010100010008040c04040400020008040404040400010004" in
    Alcotest.(check string) "its bytes" bytes (hex (State_codec.encode (State_codec.make model initial) initial))

let refused codec what text =
  match decoded codec text with
  | Ok _ -> Alcotest.failf "%s is read" what
  | Error why -> Alcotest.(check string) what what why

let faults () =
  match start "hexokinase.sc" with
  | None -> Alcotest.fail "a model with ranges"
  | Some (model, initial) ->
    let codec = State_codec.make model initial in
    let text = State_codec.encode codec initial in
    refused codec "it ends too early" "";
    refused codec "it is of version 2, and 1 is read" ("\002" ^ String.sub text 1 (String.length text - 1));
    refused codec "there is more than a state" (text ^ "\000");
    refused codec "a list is longer than what is there" "\001\127";
    refused codec "a process has no bodies" "\001\001\000\000\000\000\004\000\004\000\004\000\000";
    refused codec "a behaviour is too deep"
      ("\001\001\000\001" ^ "\000" ^ "\000\004\000\004\000\004" ^ "\000"
       ^ String.concat "" (List.init 2000 (fun _ -> "\000\004\004")))

(* {1 Numbers} *)

let number = QCheck2.Gen.(map Z.of_string (string_size ~gen:(char_range '1' '9') (int_range 1 60)))

let numbers =
  QCheck2.Test.make ~name:"rationals" ~count:2000
    QCheck2.Gen.(triple number number bool)
    (fun (n, d, minus) ->
       let q = Rat.make (if minus then Z.neg n else n) d in
       let b = Buffer.create 16 in
       Packed.put_rational b q;
       let source = Packed.source (Buffer.contents b) in
       let again = Packed.rational source in
       Rat.equal q again && Packed.at_end source)

let edges () =
  let one text =
    let z = Z.of_string text in
    let b = Buffer.create 16 in
    Packed.put_integer b z;
    let takes_bytes = Char.code (Buffer.nth b 0) land 1 = 1 in
    Alcotest.(check bool) (text ^ " is long") (Z.geq (Z.abs z) (Z.of_int 0x20000000)) takes_bytes;
    Alcotest.(check string) text text (Z.to_string (Packed.integer (Packed.source (Buffer.contents b))))
  in
  List.iter one
    [ "0"; "1"; "-1"; "536870911"; "536870912"; "-536870911"; "-536870912"; "1073741823";
      "1073741824"; "-1073741823"; "-1073741824";
      "4294967295"; "4294967296"; "18446744073709551616"; "-340282366920938463463374607431768211456" ]

let () =
  let open Scc_test_support in
  Alcotest.run "states as bytes"
    [
      ("models", List.map (fun name -> Alcotest.test_case name `Quick (round_trip name)) models);
      ("random", Property.cases [ straight; rigid; numbers ]);
      ( "other bytes",
        [
          Property.case mutated; Alcotest.test_case "faults" `Quick faults;
          Alcotest.test_case "what is written" `Quick golden;
        ] );
      ("numbers", [ Alcotest.test_case "integers" `Quick edges ]);
    ]
