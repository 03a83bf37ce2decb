(* documents.exe COUNT FOLDER: writes so many random models in XML. *)

let () =
  let count = int_of_string Sys.argv.(1) and folder = Sys.argv.(2) in
  let state = Random.State.make [| 1 |] in
  List.iteri
    (fun i model ->
       match Scc_bioshape.Write.model model with
       | Error _ -> exit 1
       | Ok text ->
         let channel = open_out_bin (Filename.concat folder (Printf.sprintf "random-%d.xml" i)) in
         output_string channel text;
         close_out channel)
    (QCheck2.Gen.generate ~rand:state ~n:count Gen.model)
