open Scc_base
open Scc_describe
let time what f = let t = Sys.time () in let x = f () in Printf.printf "%s %.1f ms\n%!" what (1000. *. (Sys.time () -. t)); x
let () =
  let text = let c = open_in_bin Sys.argv.(1) in really_input_string c (in_channel_length c) in
  for _ = 1 to 2 do
  let r = Reading.make (Source.make ~name:"/a.sc" text) in
  ignore (time "tokens" (fun () -> Lazy.force r.tokens));
  ignore (time "model" (fun () -> Lazy.force r.model));
  ignore (time "uses" (fun () -> Lazy.force r.uses));
  let off = String.length text / 2 in
  let rec find i = if text.[i] = '{' && text.[i+1] = 'r' then i + 1 else find (i+1) in let off = find off in
  ignore (time "completion" (fun () -> let k = time "known" (fun () -> Scc_assist.Known.of_text (fun _ -> None) r) in Scc_assist.Completion.at k text off));
  ignore (time "describe" (fun () -> Describe.at ~read_module:(fun ~library:_ _ -> None) r off));
  ignore (time "signature" (fun () -> Scc_assist.Signatures.at Scc_assist.Known.empty text off));
  ignore (time "colours" (fun () -> Scc_assist.Colours.of_text r));
  ignore (time "names" (fun () -> Scc_assist.Names.all r));
  ignore (time "outline" (fun () -> Scc_assist.Outline.of_text r));
  ignore (time "folds" (fun () -> Scc_assist.Outline.folds r));
  done
