(* Files as programs write them, beside the letter of the formats, and files beside files. *)
open Scc_base
open Scc_exact
open Scc_geometry
open Scc_mesh

let with_data =
  let text = Test_mesh.stl_binary 4 in
  let triangle k = String.sub text (84 + (50 * k)) 48 ^ "\003\000abc" in
  String.sub text 0 84 ^ String.concat "" (List.init 4 triangle)

let external_json = Gltf_files.gltf_json ~more:",\"uri\":\"sub/my%20data.bin\"" ~uri:false ()

let beside name =
  if String.equal name "dir/sub/my data.bin" then Ok Gltf_files.gltf_data
  else Error (name ^ " was not to be read")

let glued = "OFF4 4 6" ^ String.sub Test_mesh.off 21 (String.length Test_mesh.off - 21)

let written =
  [
    ("OFF with a glued count", "t.off", glued, ""); ("COFF with a glued count", "t.off", "C" ^ glued, "");
    ("STL with data after each triangle", "t.stl", with_data, "");
    ("STL with bytes after the end", "t.stl", Test_mesh.stl_binary 4 ^ "more", "1:279 SC0324");
    ("glTF with data beside it", "dir/t.gltf", external_json, "");
    ("glTF with animations", "t.gltf",
     Gltf_files.gltf_json
       ~head:",\"animations\":[{\"channels\":[{\"target\":{\"node\":0,\"path\":\"scale\"}}]}]" (), "1:1 SC0324");
    ("3MF with an extension that is not known", "t.3mf", Threemf_files.whole, "1:1 SC0324");
  ]

let check_written (name, path, text, expected) =
  let test () =
    match Mesh.read ~files:beside ~path text with
    | Error d -> Alcotest.fail d.Diag.message
    | Ok (set, warnings) ->
      Alcotest.(check bool) "accepted" true (Result.is_ok (Polyhedron.of_ifs set));
      let place (d : Diag.t) =
        let line, column = Source.position (Source.make ~name:path text) d.span.start in
        Printf.sprintf "%d:%d %s" line column d.code
      in
      Alcotest.(check string) "warnings" expected (String.concat " " (List.map place warnings))
  in
  Alcotest.test_case name `Quick test

(* Names that lead elsewhere are refused before a file is looked at. *)
let stays () =
  let read name = Beside.find (fun path -> Ok path) ~path:"dir/t.gltf" name in
  let ok = Alcotest.(check (result string string)) in
  ok "in the folder" (Ok "dir/a.bin") (read "a.bin");
  ok "in a folder there" (Ok "dir/b/a.bin") (read "b/a.bin");
  let out name = Alcotest.(check bool) name true (Result.is_error (read name)) in
  List.iter out [ ""; "/etc/passwd"; "../a.bin"; "b/../../a.bin"; "C:/a.bin"; "C:a"; "b\\a"; "http://a/b" ];
  List.iter out [ "a\000b"; "b//a" ]

(* Corners of integers, as they are or as parts of the greatest one. *)
let quantized () =
  let file ~kind ~normalized ~named =
    let b = Buffer.create 64 in
    let put n = if kind < 5122 then Buffer.add_uint8 b (n land 255) else Buffer.add_uint16_le b (n land 65535) in
    List.iter (fun v -> List.iter put v) [ [ -128; 0; 0 ]; [ 127; 0; 0 ]; [ 0; 1; 0 ]; [ 0; 0; 100 ] ];
    let data = Buffer.contents b in
    Printf.sprintf
      "{\"asset\":{\"version\":\"2.0\"}%s,\
       \"meshes\":[{\"primitives\":[{\"mode\":0,\"attributes\":{\"POSITION\":0}}]}],\
       \"accessors\":[{\"bufferView\":0,\"componentType\":%d,\"type\":\"VEC3\",\"count\":4%s}],\
       \"bufferViews\":[{\"buffer\":0,\"byteLength\":%d}],\
       \"buffers\":[{\"byteLength\":%d,\"uri\":\"data:;base64,%s\"}]}"
      (if named then ",\"extensionsRequired\":[\"KHR_mesh_quantization\"]" else "")
      kind
      (if normalized then ",\"normalized\":true" else "")
      (String.length data) (String.length data) (Base64.encode_string data)
  in
  let points ~kind ~normalized =
    match Test_mesh.read "t.gltf" (file ~kind ~normalized ~named:true) with
    | Ok set -> String.concat " " (List.map (fun (_, v) -> Vec.to_string v) (Array.to_list set.ifs_vertices))
    | Error d -> d.message
  in
  let check what expected found = Alcotest.(check string) what expected found in
  check "bytes" "(-128, 0, 0) (127, 0, 0) (0, 1, 0) (0, 0, 100)" (points ~kind:5120 ~normalized:false);
  check "normalized bytes" "(-1, 0, 0) (1, 0, 0) (0, 1/127, 0) (0, 0, 100/127)"
    (points ~kind:5120 ~normalized:true);
  check "bytes without a sign" "(128, 0, 0) (127, 0, 0) (0, 1, 0) (0, 0, 100)"
    (points ~kind:5121 ~normalized:false);
  check "shorts" "(-128, 0, 0) (127, 0, 0) (0, 1, 0) (0, 0, 100)" (points ~kind:5122 ~normalized:false);
  check "normalized shorts without a sign" "(65408/65535, 0, 0) (127/65535, 0, 0) (0, 1/65535, 0) (0, 0, 20/13107)"
    (points ~kind:5123 ~normalized:true);
  Alcotest.(check bool) "not without the extension" true
    (Result.is_error (Test_mesh.read "t.gltf" (file ~kind:5120 ~normalized:false ~named:false)))

let suite =
  ( "written",
    [
      ( "written",
        Alcotest.test_case "names of files beside" `Quick stays
        :: Alcotest.test_case "glTF of integers" `Quick quantized
        :: List.map check_written written );
    ] )
