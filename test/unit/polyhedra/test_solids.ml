(* Every file of specs/conformance/solids against its manifest, and no file without an entry. *)
open Scc_exact
open Scc_geometry
module J = Yojson.Safe.Util

let folder = "../../../specs/conformance/solids"

let read_file name =
  let channel = open_in_bin (Filename.concat folder name) in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let manifest =
  lazy (J.to_list (J.member "solids" (Yojson.Safe.from_string (read_file "manifest.json"))))

let file entry = J.to_string (J.member "file" entry)
let strings key entry = List.map J.to_string (J.to_list (J.member key entry))

(* In order, without repetition. *)
let kinds faults =
  let add seen f =
    let k = Polyhedron_fault.kind f in
    if List.exists (String.equal k) seen then seen else k :: seen
  in
  List.rev (List.fold_left add [] faults)

let failing (paper : Definition_4_3.t) =
  List.filter_map (fun (n, w) -> Option.map (fun _ -> n) w) paper.conditions

let check_mass entry (mass : Mass_properties.t) =
  let expect key found =
    match J.member key entry with
    | `String s -> Alcotest.(check string) key s found
    | _ -> ()
  in
  expect "volume" (Rat.to_string mass.volume);
  match J.member "centroid" entry with
  | `List l ->
    let found = List.map Rat.to_string [ mass.centroid.x; mass.centroid.y; mass.centroid.z ] in
    Alcotest.(check (list string)) "centroid" (List.map J.to_string l) found
  | _ -> ()

let check_readable entry ifs =
  let report = Solid_report.make ifs in
  let faults =
    match report.verdict with
    | Accepted (_, mass) ->
      check_mass entry mass;
      []
    | Rejected faults -> kinds faults
  in
  Alcotest.(check (list string)) "faults" (strings "faults" entry) faults;
  Alcotest.(check bool) "accepted" (J.to_bool (J.member "accepted" entry)) (Solid_report.accepted report);
  let fails = List.map J.to_int (J.to_list (J.member "paper_fails" entry)) in
  Alcotest.(check (list int)) "conditions of Definition 4.3 that fail" fails (failing report.paper);
  Alcotest.(check bool) "a text" true (String.length (Solid_report.to_text ~name:"solid" report) > 0)

let check entry () =
  let name = file entry in
  let found = Scc_mesh.Mesh.read ~files:Scc_mesh.Beside.none ~path:name (read_file name) in
  match (found, J.member "unreadable" entry) with
  | Ok (ifs, _), `Null -> check_readable entry ifs
  | Error d, `String code -> Alcotest.(check string) "code" code d.Scc_base.Diag.code
  | Ok _, _ -> Alcotest.fail "read, though it should be refused"
  | Error d, _ -> Alcotest.fail d.Scc_base.Diag.message

let complete () =
  let listed = List.sort String.compare (List.map file (Lazy.force manifest)) in
  let there =
    List.filter (fun f -> not (String.equal f "manifest.json")) (Array.to_list (Sys.readdir folder))
  in
  Alcotest.(check (list string)) "files" (List.sort String.compare there) listed

(* The kinds that no readable file can show are those that the reader refuses. *)
let all_kinds () =
  let wanted =
    [
      "no-faces"; "flat"; "open-edge"; "repeated-edge"; "turned-face"; "same-position"; "unused-vertex";
      "off-plane"; "degenerate-face"; "self-crossing"; "not-convex"; "coplanar-neighbours"; "in-plane";
      "inward"; "separate-solids";
    ]
  in
  let seen = List.concat_map (strings "faults") (Lazy.force manifest) in
  let missing = List.filter (fun k -> not (List.exists (String.equal k) seen)) wanted in
  Alcotest.(check (list string)) "kinds without a file" [] missing

(* D-3: passes all seven conditions, and is refused. *)
let insufficient () =
  let passes e =
    J.to_list (J.member "paper_fails" e) = []
    && (not (J.to_bool (J.member "accepted" e)))
    && J.member "unreadable" e = `Null
  in
  let found = List.map file (List.filter passes (Lazy.force manifest)) in
  let known =
    [
      "folded-flat.off"; "inside-out.off"; "loose-lid.off"; "open-box-spare-vertex.off"; "star-bipyramid.off";
      "tetrahedra-at-an-edge-open.off"; "two-open-boxes.off";
    ]
  in
  Alcotest.(check (list string)) "counterexamples" known (List.sort String.compare found)

let suite =
  let case e = Alcotest.test_case (file e) `Quick (check e) in
  ("solids",
   [
     ("I-2: specs/conformance/solids", List.map case (Lazy.force manifest));
     ( "the manifest",
       [
         Alcotest.test_case "lists every file" `Quick complete;
         Alcotest.test_case "has every kind of fault" `Quick all_kinds;
         Alcotest.test_case "D-3: what passes the seven conditions and bounds no convex solid" `Quick
           insufficient;
       ] );
   ])
