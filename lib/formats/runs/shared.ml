open Scc_exact
open Scc_json
open Json_format

let file = "common"
let named name text t = named ~file name (about text t)
let rational = named "rational" "An exact rational p/q in lowest terms, q > 0." rational
let three each items rebuild = into rebuild (from items (list ~least:3 ~most:3 each))

let vector =
  let rebuild = function [ x; y; z ] -> Ok (Vec.make x y z) | _ -> Error "is no vector" in
  named "vector" "x, y, z." (three rational (fun (v : Vec.t) -> [ v.x; v.y; v.z ]) rebuild)

let matrix =
  named "matrix" "Rows." (three vector (fun (m : Mat.t) -> [ m.r0; m.r1; m.r2 ]) (fun _ -> Ok ()))

let integer_text = form [ { set = "-"; least = 0; most = Some 1 }; { set = "0-9"; least = 1; most = None } ]

let seed = named "seed" "Of a random choice: an integer of 64 bits." (from Int64.to_string integer_text)

let quaternion =
  let items (q : Quaternion.t) = List.map Z.to_string [ q.w; q.x; q.y; q.z ] in
  checked (from items (list ~least:4 ~most:4 integer_text))
  |> named "quaternion" "The rotation of w + x i + y j + z k: integers without a common factor."

let letters word : Json_schema.run list =
  let one c = { Json_schema.set = String.make 1 c; least = 1; most = Some 1 } in
  List.map one (List.of_seq (String.to_seq word))

let digest =
  named "digest"
    "MD5 of the model's text and the files that it reads, meshes and imports; each as <length of its \
     name>:<name><length>:<bytes>, the model first and with an empty name."
    (form (letters "md5:" @ [ { set = "0-9a-f"; least = 32; most = Some 32 } ]))

let digit c = Printf.sprintf "%02x" (Char.code c)
let hex text = String.concat "" (List.map digit (List.of_seq (String.to_seq text)))

let bytes =
  from hex (Json_format.repeated [ { set = "0-9a-f"; least = 2; most = Some 2 } ])

let code = form (letters "SC" @ [ { set = "0-9"; least = 4; most = Some 4 } ])
let exit = named "exit" "The exit code of the command." (one_of [ 0; 1; 2; 3; 4; 64; 70; 74 ])
let texts = list text
let numbered letter =
  form (letters letter @ [ { set = "1-9"; least = 1; most = Some 1 }; { set = "0-9"; least = 0; most = None } ])

let from_one = integer ~least:1 ()
let semantics () =
  field "semantics" some_text (fun _ -> Scc_calculus.Parameters.version) ~about:"Version of the rule book."

let head format version = [ fixed "format" (`String format); fixed "version" (`Int version) ]
