open Scc_json

type 'store t = {
  name : string;
  params : Json_schema.member list;
  result : Json_schema.t;
  work : 'store -> Read.params -> Reply.t;
}

let make name params result work =
  let work store p =
    Read.only p params;
    Reply.of_format result (work store p)
  in
  { name; params; result = Json_format.schema result; work }

(* The member [limits]: of all methods, and of those that explore. *)
let seconds = Read.member "seconds" Read.positive
let states = Read.member "states" Read.natural
let depth = Read.member "depth" Read.natural
let time = Read.member "time" Read.not_negative
let plain = Read.fields [ Read.may seconds ]
let plain_limits = Read.member "limits" { plain with schema = Read.defined "limits" plain.schema }
let all = Read.fields Read.[ may seconds; may states; may depth; may time ]
let all_limits = Read.member "limits" { all with schema = Read.defined "limits_of_exploration" all.schema }
let limits = Read.may plain_limits
