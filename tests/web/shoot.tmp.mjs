import { chromium } from 'playwright-core';
const b=await chromium.launch({executablePath:'/usr/bin/chromium',args:['--no-sandbox','--disable-gpu','--disable-quic','--no-first-run','--disable-background-networking','--disable-component-update','--disable-sync']});
for (const [w,h] of [[1280,800],[390,844],[360,740],[900,900],[1700,950]]) for (const t of ['light','dark']) {
 if (w!==1280&&w!==390&&t==='dark') continue;
 const p=await b.newPage({viewport:{width:w,height:h},colorScheme:t});
 p.on('console',m=>console.log(w,t,m.type(),m.text())); p.on('pageerror',e=>console.log('ERR',e.stack));
 await p.goto('http://127.0.0.1:8123/'); await p.waitForTimeout(1200);
 await p.screenshot({path:`/tmp/shots/${w}-${t}.png`,fullPage:true});
 console.log(w, await p.evaluate(()=>document.documentElement.scrollWidth), await p.evaluate(()=>document.querySelector('#chart').getBoundingClientRect().bottom));
 await p.close();
}
await b.close();
